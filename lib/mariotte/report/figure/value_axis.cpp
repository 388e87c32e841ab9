#include "mariotte/report/figure/value_axis.hpp"

#include <fmt/format.h>

#include "mariotte/report/figure/axis_names.hpp"
#include "mariotte/report/figure/gnuplot.hpp"
#include "mariotte/report/number.hpp"
#include "mariotte/study/sweep/slope_columns.hpp"

namespace mariotte::report {
namespace {

/// Whether a user has named it.
bool is_own(const study::Column& column) {
  return !column.written.empty();
}

/// Text that a format of sprintf leaves as it is.
std::string without_format(std::string text) {
  for (std::size_t at = 0; (at = text.find('%', at)) != std::string::npos; at += 2) text.insert(at, 1, '%');
  return text;
}

/// Brings what is shown, whose magnitude is `size`, into the unit that suits it; as `display_for` does.
std::string prefix_settings(const std::string& name, const study::Column& column, const std::string& axis) {
  if (!takes_prefix(column.unit))
    return fmt::format("factor = 1.0\nset {}label {}\n", axis, quoted(with_unit(name, column.unit)));
  return fmt::format(R"(steps = size == 0 || (size >= 0.1 && size < 1e4) ? 0 : floor(log10(size) / 3)
steps = steps < -5 ? -5 : steps > {0} ? {0} : steps
factor = 10.0 ** (-3 * steps)
set {1}label sprintf({2}, steps == 0 ? '' : word('f p n µ m - k M G T', steps + 6))
)",
                     column.unit == "s" ? 0 : 4, axis,
                     quoted(with_unit(without_format(name), "%s" + column.unit)));
}

/// Space around a number that is the same everywhere, and ticks: whole ones of what is counted.
std::string whole_ticks(const study::Column& column, const std::string& axis) {
  const auto any = fmt::format("set {}tics autofreq\n", axis);
  if (!column.key.ends_with(".count")) return any;
  return any + fmt::format("margin = margin > 0 ? 0.5 : 0\nif (high - low < 8) {{ set {}tics 1 }}\n", axis);
}

}  // namespace

std::string long_label(const std::string& key, const study::Column& column) {
  if (study::is_slope(column.key)) return "slope " + name_of_slope(key);
  return is_own(column) ? greek(key) : name_of_result(key, column.symbol);
}

std::string short_label(const study::Column& column) {
  if (study::is_slope(column.key)) return name_of_slope(column.key);
  return is_own(column) ? greek(column.key) : short_name_of_result(column.key, column.symbol);
}

std::string value_axis(const std::vector<std::size_t>& places, const std::string& key,
                       const study::Column& column, const std::string& axis) {
  return fmt::format(R"(set autoscale {0}
low = 1e300; high = -1e300
show(value) = (low = value < low ? value : low, high = value > high ? value : high, 0)
do for [c in '{1}'] {{
  stats [*:*] [*:*] 'plot.csv' using (valid(int(c)) ? show(column(int(c))) : 0) nooutput
}}
size = low > high ? 0 : abs(low) > abs(high) ? abs(low) : abs(high)
{2}margin = high - low > 1e-9 * size ? 0 : size > 0 ? 0.001 * size : 1
{3}if (margin > 0 && low <= high) {{ set {0}range [factor*(low-margin):factor*(high+margin)] }}
unset label
if (low > high) {{ set {0}range [-1:1]; set label 'no numbers' at graph 0.5, 0.5 center }}
)",
                     axis, fmt::join(places, " "), prefix_settings(long_label(key, column), column, axis),
                     whole_ticks(column, axis));
}

std::string logarithmic_colours() {
  return R"(set cbtics autofreq
unset logscale cb
if (low > 0) {
  set logscale cb
  least = factor * low; most = factor * high; step = 10.0 ** floor(log10(most - least + 1e-9 * most))
  name(at) = at < 0.01 && most > 1000 * least ? gprintf('10^{%T}', at) : sprintf('%g', at)
  tick(at) = at > 0.999 * least ? sprintf("%s'%s' %g", ticks eq '' ? '' : ', ', name(at), at) : ''
  ticks = ''
  if (most >= 5 * least) {
    do for [p=floor(log10(least)):ceil(log10(most))] { do for [d in (most > 1000 * least ? '1' : '1 2 5')] {
      ticks = ticks.tick(d * 10.0 ** p)
    } }
  } else {
    do for [k=ceil(least/step):floor(most/step)] { ticks = ticks.tick(k * step) }
  }
  eval 'set cbtics out nomirror ('.ticks.')'
}
)";
}

std::string scaled(std::size_t place) {
  return fmt::format("(valid({0}) ? factor*column({0}) : NaN)", place);
}

}  // namespace mariotte::report
