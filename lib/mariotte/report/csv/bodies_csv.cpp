#include <fmt/format.h>

#include <array>

#include "mariotte/report/csv/csv.hpp"
#include "mariotte/report/number.hpp"

namespace mariotte::report {
namespace {

using model::BodyEvent;

struct Column {
  const char* name;
  BodyEvent event;
};
constexpr std::array event_columns = {
    Column{"close", BodyEvent::close},     Column{"open", BodyEvent::open},
    Column{"stick", BodyEvent::stick},     Column{"slip", BodyEvent::slip},
    Column{"reverse", BodyEvent::reverse}, Column{"load", BodyEvent::load},
    Column{"unload", BodyEvent::unload},   Column{"slack", BodyEvent::slack},
    Column{"grip", BodyEvent::grip},       Column{"touch", BodyEvent::touch},
    Column{"part", BodyEvent::part},       Column{"yield", BodyEvent::yield}};

/// "x1 [m],y1 [m]" for names with their unit and one thing.
std::string names(std::initializer_list<const char*> all, std::size_t which, const char* unit) {
  std::string text;
  for (const auto* name : all) text += fmt::format(",{}{} [{}]", name, which, unit);
  return text;
}

std::string header(std::size_t bodies, std::size_t contacts, bool plane) {
  std::string text = "time [s]";
  for (std::size_t i = 1; i <= bodies; ++i)
    text += plane ? names({"x", "y"}, i, "m") + names({"angle"}, i, "rad") + names({"vx", "vy"}, i, "m/s") +
                        names({"spin"}, i, "rad/s")
                  : names({"x", "y", "z"}, i, "m") + names({"qw", "qx", "qy", "qz"}, i, "1") +
                        names({"vx", "vy", "vz"}, i, "m/s") + names({"spinx", "spiny", "spinz"}, i, "rad/s");
  for (std::size_t i = 1; i <= contacts; ++i)
    text += names({"gap"}, i, "m") + names({"normal_force"}, i, "N") +
            (plane ? names({"friction_x", "friction_y"}, i, "N") + names({"slip_x", "slip_y"}, i, "m/s")
                   : names({"friction_x", "friction_y", "friction_z"}, i, "N") +
                         names({"slip_x", "slip_y", "slip_z"}, i, "m/s"));
  return text + "\n";
}

void append(std::string& text, std::initializer_list<double> values) {
  for (const double value : values) (text += ',') += exact(value);
}
void append(std::string& text, const Vector3& v, bool plane) {
  append(text, {v.e1, v.e2});
  if (!plane) append(text, {v.e3});
}
void append(std::string& text, const impact::BodyEnd& body, bool plane) {
  append(text, body.position, plane);
  if (plane)
    append(text, {body.angle});
  else
    append(text, {body.attitude.w, body.attitude.x, body.attitude.y, body.attitude.z});
  append(text, body.velocity, plane);
  if (plane)
    append(text, {body.spin.e3});
  else
    append(text, body.spin, plane);
}

}  // namespace

std::string events_csv(const impact::BodiesImpact& impact) {
  std::string text = "time [s]";
  for (const auto& column : event_columns) text += fmt::format(",{}", column.name);
  text += "\n";
  for (const auto& event : impact.events) {
    text += exact(event.time);
    for (const auto& column : event_columns) {
      std::vector<Index> counted = event.of(column.event);
      for (auto& one : counted) ++one;
      text += fmt::format(",{}", fmt::join(counted, " "));
    }
    text += "\n";
  }
  return text;
}

std::string trace_csv(const impact::BodiesImpact& impact) {
  const auto& trace = impact.trace;
  const bool plane = impact.dimension == 2;
  std::string text = header(impact.body.size(), impact.contacts.size(), plane);
  for (std::size_t row = 0; row < trace.time.size(); ++row) {
    text += exact(trace.time[row]);
    for (const auto& body : trace.body[row]) append(text, body, plane);
    for (const auto& contact : impact.contacts) {
      const auto c = static_cast<std::size_t>(contact.contact);
      append(text, {trace.gap[row][c], trace.force[row][c]});
      append(text, trace.friction[row][c], plane);
      append(text, trace.slip[row][c], plane);
    }
    text += "\n";
  }
  return text;
}

}  // namespace mariotte::report
