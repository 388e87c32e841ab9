#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <tuple>

#include "mariotte/report/figure/time_figure.hpp"
#include "mariotte/report/page/motion.hpp"
#include "mariotte/report/page/motion_frames.hpp"

namespace mariotte::report {
namespace {

/// Which components of a vector lie to the right and upwards in the picture.
struct View {
  int right = 0, up = 1;
  double x(const Vector3& v) const { return component(v, right); }
  double y(const Vector3& v) const { return component(v, up); }
  /// The plane is a line.
  bool is_along(const model::Plane& plane) const { return component(plane.normal, 3 - right - up) == 0; }
};

/// In space along an axis that lies in all planes, so that they are lines; along z if none does.
View view_of(const model::Bodies& bodies) {
  for (const View view : {View{0, 1}, View{0, 2}, View{1, 2}})
    if (std::all_of(bodies.plane.begin(), bodies.plane.end(),
                    [&](const auto& plane) { return view.is_along(plane); }))
      return view;
  return {};
}

/// What is seen of a body: one of its spheres, or where its mass is, of which nothing else tells.
struct Seen {
  std::size_t body;
  Vector3 centre;
  double radius;
};

/// The first sphere of each body, in the order of `seen_of`.
std::vector<int> first_spheres(const model::Bodies& bodies) {
  std::vector<int> first{0};
  for (const auto& body : bodies.body) first.push_back(first.back() + static_cast<int>(body.spheres.size()));
  return first;
}

bool stands_aside(const model::Body& body) {
  return body.spheres.size() == 1 && norm(body.spheres[0].centre) > 0;
}

/// Spheres of all bodies, then mass centres of those that have one sphere beside it; a point is a disc that
/// can be seen.
std::vector<Seen> seen_of(const model::Bodies& bodies) {
  constexpr double visible = 0.03;
  std::vector<Seen> seen, centres;
  for (std::size_t i = 0; i < bodies.body.size(); ++i) {
    const auto& body = bodies.body[i];
    double reach = 0;
    for (const auto& sphere : body.spheres) reach = std::max(reach, norm(sphere.centre));
    for (const auto& sphere : body.spheres)
      seen.push_back({i, sphere.centre, sphere.radius > 0 ? sphere.radius : visible * reach});
    if (stands_aside(body)) centres.push_back({i, {}, visible * reach});
  }
  seen.insert(seen.end(), centres.begin(), centres.end());
  return seen;
}

/// x and y of all of them at one sample.
std::vector<double> places(const std::vector<Seen>& seen, const View& view,
                           const std::vector<impact::BodyEnd>& sample) {
  std::vector<double> row;
  for (const auto& one : seen) {
    const auto centre = sample[one.body].position + rotate(sample[one.body].attitude, one.centre);
    row.insert(row.end(), {view.x(centre), view.y(centre)});
  }
  return row;
}

/// The contact as it stands when its force is largest.
DiscContact contact_of(const model::Bodies& bodies, const View& view, Index c,
                       const impact::BodiesTrace& trace, const Rows& rows) {
  const auto& contact = bodies.contact[c];
  const auto first = first_spheres(bodies);
  const int to = first[contact.b.owner] + static_cast<int>(contact.b.sphere);
  if (contact.a.is_plane()) {
    const auto& normal = bodies.plane[contact.a.owner].normal;
    const double x = view.x(normal), y = view.y(normal);
    return {-1, to, x, y, x, y};
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

/// Contacts and their forces at the samples; after all of them those with friction once more, across.
struct Pushes {
  std::vector<DiscContact> contact;
  Rows force;
};

Pushes pushes_of(const model::Bodies& bodies, const View& view, const impact::BodiesTrace& trace,
                 const Rows& rows) {
  Pushes pushes{{}, trace.force};
  for (Index c = 0; c < std::ssize(bodies.contact); ++c)
    pushes.contact.push_back(contact_of(bodies, view, c, trace, rows));
  for (int c = 0; c < static_cast<int>(bodies.contact.size()); ++c) {
    const auto slips = [&](const auto& friction) { return norm(friction[c]) > 0; };
    if (std::none_of(trace.friction.begin(), trace.friction.end(), slips)) continue;
    auto across = pushes.contact[c];
    std::tie(across.x, across.y) = std::pair{across.y, -across.x};
    across.same_as = c;
    pushes.contact.push_back(across);
    for (std::size_t row = 0; row < pushes.force.size(); ++row) {
      const auto& f = trace.friction[row][c];
      pushes.force[row].push_back(view.x(f) * across.x + view.y(f) * across.y);
    }
  }
  return pushes;
}

bool is_floor(const model::Plane& plane, const View& view) {
  return view.y(plane.normal) == 1 && view.y(plane.point) == 0 && norm(plane.velocity) == 0;
}

/// Planes that stand across the picture, but for the floor.
Json planes_of(const model::Bodies& bodies, const View& view) {
  auto list = Json::array();
  for (const auto& plane : bodies.plane)
    if (!is_floor(plane, view) && view.is_along(plane))
      list.push_back({{"x", view.x(plane.point)},
                      {"y", view.y(plane.point)},
                      {"normal", {view.x(plane.normal), view.y(plane.normal)}},
                      {"speed", dot(plane.velocity, plane.normal)}});
  return list;
}

/// Discs of one body that are joined: two by a link, more by an outline.
void join(const model::Bodies& bodies, Json& motion) {
  const auto first = first_spheres(bodies);
  int centre = first.back();
  for (std::size_t i = 0; i < bodies.body.size(); ++i) {
    if (stands_aside(bodies.body[i])) motion["links"].push_back({first[i], centre++});
    if (first[i + 1] - first[i] == 2) motion["links"].push_back({first[i], first[i] + 1});
    if (first[i + 1] - first[i] <= 2) continue;
    auto outline = Json::array();
    for (int k = first[i]; k < first[i + 1]; ++k) outline.push_back(k);
    motion["outlines"].push_back(std::move(outline));
  }
}

}  // namespace

Json motion(const impact::BodiesImpact& impact, const scene::Scene& scene) {
  const auto& bodies = std::get<model::Bodies>(scene.model);
  const auto& trace = impact.trace;
  const auto seen = seen_of(bodies);
  const View view = view_of(bodies);
  if (trace.time.size() < 2 || seen.size() > most_discs) return {};
  std::vector<Disc> discs;
  for (const auto& one : seen) discs.push_back({0, 0, one.radius});
  Rows rows;
  for (const auto& sample : trace.body) rows.push_back(places(seen, view, sample));
  const auto pushes = pushes_of(bodies, view, trace, rows);
  const auto windows = time_axis(action_of(trace), {}, scene.figure).windows;
  Course course{instants(windows, trace.time, pushes.force), {}, {}};
  for (const double time : course.time) {
    const auto at = position(trace.time, time);
    course.place.push_back(between(rows, at));
    course.force.push_back(between(pushes.force, at));
  }
  auto all = as_json(discs, pushes.contact, course);
  all["floor"] = std::any_of(bodies.plane.begin(), bodies.plane.end(),
                             [&](const auto& plane) { return is_floor(plane, view); });
  all["planes"] = planes_of(bodies, view);
  constexpr std::string_view axes = "xyz";
  if (bodies.dimension == 3) all["axes"] = {axes.substr(view.right, 1), axes.substr(view.up, 1)};
  join(bodies, all);
  return all;
}

}  // namespace mariotte::report
