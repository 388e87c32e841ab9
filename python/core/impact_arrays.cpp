#include "impact_arrays.hpp"

#include "arrays.hpp"
#include "mariotte/core/overload.hpp"

namespace mariotte::python {
namespace {

using Contacts = impact::ContactImpact;
using Bodies = impact::BodiesImpact;
using Body = impact::MicrobodyImpact;
using impact::BodyEnd;
using History = impact::ContactHistory;
using BodyHistory = impact::BodyContactHistory;

/// The whole of one kind; an attribute that other kinds do not have.
template <class Kind>
const Kind& whole(const Impact& impact) {
  const Kind* found = nullptr;
  std::visit(
      [&](const auto& one) {
        if constexpr (std::is_convertible_v<decltype(&one), const Kind*>) found = &one;
      },
      impact.whole());
  if (!found) throw py::attribute_error("results of such a scene do not have this");
  return *found;
}

py::array vector_view(const Vector3& vector, const py::object& self) {
  return view(&vector.e1, {3}, {sizeof(double)}, self);
}

py::array velocity(const py::object& self) {
  const auto& impact = self.cast<const Impact&>();
  if (impact.brief()) return view(impact.brief()->velocity, self);
  return std::visit(
      Overload{[&](const Body& one) { return vector_view(one.final.velocity, self); },
               [&](const Bodies& one) { return view(one.body, &BodyEnd::velocity, one.dimension, self); },
               [&](const auto& one) { return view(one.velocity, self); }},
      impact.whole());
}

py::array position(const py::object& self) {
  const auto& impact = self.cast<const Impact&>();
  if (const auto* const many = std::get_if<Bodies>(&impact.whole()))
    return view(many->body, &BodyEnd::position, many->dimension, self);
  return vector_view(whole<Body>(impact).final.position, self);
}

py::array spin(const py::object& self) {
  const auto& impact = self.cast<const Impact&>();
  if (const auto* const many = std::get_if<Bodies>(&impact.whole()))
    return view_of_spins(many->body, &BodyEnd::spin, many->dimension, self);
  return vector_view(whole<Body>(impact).final.spin, self);
}

py::array quaternion(const py::object& self) {
  const auto& bodies = whole<Bodies>(self.cast<const Impact&>()).body;
  const double* const first = bodies.empty() ? nullptr : &bodies.front().attitude.w;
  return view(first, {std::ssize(bodies), 4}, {sizeof(BodyEnd), sizeof(double)}, self);
}

py::array impulse(const py::object& self) {
  const auto& impact = self.cast<const Impact&>();
  return impact.brief() ? view(impact.brief()->impulse, self)
                        : view(whole<Contacts>(impact).contacts, &History::impulse, self);
}

template <class Kind, auto list, auto member>
py::array of(const py::object& self) {
  return view(whole<Kind>(self.cast<const Impact&>()).*list, member, self);
}
template <auto member>
constexpr auto of_history = &of<Contacts, &Contacts::contacts, member>;
template <auto member>
constexpr auto of_body_history = &of<Bodies, &Bodies::contacts, member>;

/// What contacts with and without friction call the same.
template <auto without, auto with>
py::array of_either(const py::object& self) {
  return std::holds_alternative<Bodies>(self.cast<const Impact&>().whole()) ? of_body_history<with>(self)
                                                                            : of_history<without>(self);
}

template <auto member>
py::array of_contacts(const py::object& self) {
  return view(whole<Contacts>(self.cast<const Impact&>()).*member, self);
}

/// In the plane along the normal turned by 90°.
py::array tangential_impulse(const py::object& self) {
  const auto& bodies = whole<Bodies>(self.cast<const Impact&>());
  if (bodies.dimension == 3) return view(bodies.contacts, &BodyHistory::tangential_impulse, 3, self);
  const double* const first =
      bodies.contacts.empty() ? nullptr : &bodies.contacts.front().tangential_impulse.e1;
  return view(first, {std::ssize(bodies.contacts)}, {sizeof(BodyHistory)}, self);
}

/// In the order of `impact::each_loss`.
py::tuple losses(const py::object& self) {
  const auto& contacts = whole<Bodies>(self.cast<const Impact&>()).contacts;
  const auto one = [&](double impact::ContactLosses::*member) -> py::array {
    const double* const first = contacts.empty() ? nullptr : &(contacts.front().losses.*member);
    return view(first, {std::ssize(contacts)}, {sizeof(BodyHistory)}, self);
  };
  py::tuple all(impact::each_loss.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = one(impact::each_loss[i]);
  return all;
}

py::list between(const Impact& impact) {
  py::list all;
  for (const auto& contact : whole<Bodies>(impact).contacts)
    all.append(py::make_tuple(contact.between[0], contact.between[1]));
  return all;
}

py::array ends(const std::vector<impact::Period>& periods) {
  std::vector<double> ends;
  for (const auto& [start, end] : periods) ends.insert(ends.end(), {start, or_nan(end)});
  return owned(std::move(ends), {std::ssize(periods), 2});
}

py::list periods(const Impact& impact) {
  py::list all;
  const auto add = [&](const auto& contacts) {
    for (const auto& contact : contacts) all.append(ends(contact.periods));
  };
  if (const auto* const bodies = std::get_if<Bodies>(&impact.whole()))
    add(bodies->contacts);
  else
    add(whole<Contacts>(impact).contacts);
  return all;
}

}  // namespace

void add_arrays(py::class_<Impact>& type) {
  type.def_property_readonly("velocity", &velocity)
      .def_property_readonly("position", &position)
      .def_property_readonly("spin", &spin)
      .def_property_readonly("angle", &of<Bodies, &Bodies::body, &BodyEnd::angle>)
      .def_property_readonly("quaternion", &quaternion)
      .def_property_readonly("impulse", &impulse)
      .def_property_readonly(
          "icr", [](const py::object& self) { return view(self.cast<const Impact&>().icr(), self); })
      .def_property_readonly("gap", &of_contacts<&Contacts::gap>)
      .def_property_readonly("impulse_direction", &of_contacts<&Contacts::impulse_direction>)
      .def_property_readonly("normal_impulse", of_body_history<&BodyHistory::normal_impulse>)
      .def_property_readonly("tangential_impulse", &tangential_impulse)
      .def_property_readonly("peak_force", &of_either<&History::peak_force, &BodyHistory::peak_force>)
      .def_property_readonly("peak_friction", of_body_history<&BodyHistory::peak_friction>)
      .def_property_readonly("peak_indentation",
                             &of_either<&History::peak_indentation, &BodyHistory::peak_indentation>)
      .def_property_readonly("stored", &of_either<&History::stored, &BodyHistory::stored>)
      .def_property_readonly("dissipated", of_history<&History::dissipated>)
      .def_property_readonly("plastic_work", of_history<&History::plastic>)
      .def_property_readonly("adhesion_loss", of_history<&History::adhesion>)
      .def_property_readonly("permanent_indentation", of_history<&History::permanent_indentation>)
      .def_property_readonly("losses", &losses)
      .def_property_readonly("between", &between)
      .def_property_readonly("periods", &periods);
}

}  // namespace mariotte::python
