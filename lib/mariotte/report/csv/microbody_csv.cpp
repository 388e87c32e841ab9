#include <fmt/format.h>

#include "mariotte/report/csv/csv.hpp"
#include "mariotte/report/number.hpp"

namespace mariotte::report {
namespace {

std::string cell(const std::vector<Index>& tips, Index sign = 1) {
  std::vector<Index> counted;
  for (const Index tip : tips) counted.push_back(sign * (tip + 1));
  return fmt::format("{}", fmt::join(counted, " "));
}

std::string signs(const impact::TipEvents& event) {
  const auto push = cell(event.push), pull = cell(event.pull, -1);
  return push.empty() || pull.empty() ? push + pull : push + " " + pull;
}

std::string header(std::size_t tips) {
  std::string text =
      "time [s],height [m],x2 [m],x3 [m],v1 [m/s],v2 [m/s],v3 [m/s],spin1 [rad/s],spin2 [rad/s],"
      "spin3 [rad/s],qw,qx,qy,qz";
  for (std::size_t i = 1; i <= tips; ++i)
    text += fmt::format(
        ",gap{0} [m],normal_force{0} [N],friction{0}_2 [N],friction{0}_3 [N],slip{0}_2 [m/s],"
        "slip{0}_3 [m/s]",
        i);
  return text + "\n";
}

void append_cells(std::string& text, std::initializer_list<double> values) {
  for (const double value : values)
    text.append(text.empty() || text.back() == '\n' ? "" : ",").append(exact(value));
}

}  // namespace

std::string events_csv(const impact::MicrobodyImpact& impact) {
  std::string text = "time [s],open,close,stick,slip,force_sign,capture\n";
  for (const auto& event : impact.events)
    text += fmt::format("{},{},{},{},{},{},{}\n", exact(event.time), cell(event.open), cell(event.close),
                        cell(event.stick), cell(event.slip), signs(event), cell(event.capture));
  return text;
}

std::string trace_csv(const impact::MicrobodyImpact& impact) {
  const auto& trace = impact.trace;
  const std::size_t tips = trace.gap.empty() ? 1 : trace.gap[0].size();
  std::string text = header(tips);
  for (std::size_t row = 0; row < trace.state.size(); ++row) {
    const auto& [time, x, q, v, w] = trace.state[row];
    append_cells(text, {time, x.e1, x.e2, x.e3, v.e1, v.e2, v.e3, w.e1, w.e2, w.e3, q.w, q.x, q.y, q.z});
    for (std::size_t i = 0; i < tips; ++i) {
      const auto& friction = trace.friction[row][i];
      const auto& slip = trace.slip[row][i];
      append_cells(
          text, {trace.gap[row][i], trace.normal_force[row][i], friction.e2, friction.e3, slip.e2, slip.e3});
    }
    text += "\n";
  }
  return text;
}

}  // namespace mariotte::report
