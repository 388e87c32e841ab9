#include <algorithm>
#include <nlohmann/json.hpp>

#include "mariotte/report/figure/time_figure.hpp"
#include "mariotte/report/page/motion.hpp"
#include "mariotte/report/page/motion_frames.hpp"

namespace mariotte::report {
namespace {

/// The first disc of each body.
std::vector<int> first_discs(const model::Bodies& bodies) {
  std::vector<int> first{0};
  for (const auto& body : bodies.body) first.push_back(first.back() + static_cast<int>(body.spheres.size()));
  return first;
}

/// Spheres of all bodies; a point is a disc that can be seen.
std::vector<Disc> discs_of(const model::Bodies& bodies) {
  std::vector<Disc> discs;
  for (const auto& body : bodies.body) {
    double reach = 0;
    for (const auto& sphere : body.spheres) reach = std::max(reach, norm(sphere.centre));
    for (const auto& sphere : body.spheres)
      discs.push_back({0, 0, sphere.radius > 0 ? sphere.radius : 0.03 * reach});
  }
  return discs;
}

/// x and y of all spheres at one sample.
std::vector<double> places(const model::Bodies& bodies, const std::vector<impact::BodyEnd>& sample) {
  std::vector<double> row;
  for (std::size_t i = 0; i < sample.size(); ++i)
    for (const auto& sphere : bodies.body[i].spheres) {
      const auto centre = sample[i].position + rotate(sample[i].attitude, sphere.centre);
      row.insert(row.end(), {centre.e1, centre.e2});
    }
  return row;
}

/// The contact as it stands when its force is largest.
DiscContact contact_of(const model::Bodies& bodies, Index c, const impact::BodiesTrace& trace,
                       const Rows& rows) {
  const auto& contact = bodies.contact[c];
  const auto first = first_discs(bodies);
  const int to = first[contact.b.owner] + static_cast<int>(contact.b.sphere);
  if (contact.a.is_plane()) {
    const auto& normal = bodies.plane[contact.a.owner].normal;
    return {-1, to, normal.e1, normal.e2};
  }
  const int from = first[contact.a.owner] + static_cast<int>(contact.a.sphere);
  std::size_t best = 0;
  for (std::size_t row = 0; row < trace.time.size(); ++row)
    if (trace.force[row][c] > trace.force[best][c]) best = row;
  const double x = rows[best][2 * to] - rows[best][2 * from];
  const double y = rows[best][2 * to + 1] - rows[best][2 * from + 1];
  const double size = std::max(std::hypot(x, y), 1e-300);
  return {from, to, x / size, y / size};
}

bool has_floor(const model::Bodies& bodies) {
  return std::any_of(bodies.plane.begin(), bodies.plane.end(), [](const model::Plane& plane) {
    return plane.normal.e1 == 0 && plane.normal.e2 == 1 && plane.point.e2 == 0 && norm(plane.velocity) == 0;
  });
}

}  // namespace

Json motion(const impact::BodiesImpact& impact, const scene::Scene& scene) {
  const auto& bodies = std::get<model::Bodies>(scene.model);
  const auto& trace = impact.trace;
  const auto discs = discs_of(bodies);
  if (trace.time.size() < 2 || discs.size() > most_discs) return {};
  Rows rows;
  for (const auto& sample : trace.body) rows.push_back(places(bodies, sample));
  std::vector<DiscContact> contacts;
  for (Index c = 0; c < std::ssize(bodies.contact); ++c)
    contacts.push_back(contact_of(bodies, c, trace, rows));
  const auto times = instants(time_axis(action_of(trace), {}, scene.figure).windows);
  Course course{times, {}, {}};
  for (const double time : times) {
    const auto at = position(trace.time, time);
    course.place.push_back(between(rows, at));
    course.force.push_back(between(trace.force, at));
  }
  auto all = as_json(discs, contacts, course);
  all["floor"] = has_floor(bodies);
  const auto first = first_discs(bodies);
  for (std::size_t i = 0; i < bodies.body.size(); ++i)
    for (int k = first[i] + 1; k < first[i + 1]; ++k) all["links"].push_back({k - 1, k});
  return all;
}

}  // namespace mariotte::report
