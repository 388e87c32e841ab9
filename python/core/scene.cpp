// Scenes: read by the reader of the command, so that errors are the same.
#include <pybind11/stl.h>

#include <nlohmann/json.hpp>

#include "arrays.hpp"
#include "bindings.hpp"
#include "mariotte/core/overload.hpp"
#include "mariotte/report/json/json.hpp"
#include "mariotte/scene/text_file.hpp"
#include "scene_box.hpp"

namespace mariotte::python {
namespace {

using scene::Purpose;

/// For the law alone masses and velocities are enough.
Purpose purpose_of(const scene::Document& document) {
  const auto* root = document.tree.table();
  const auto has = [&](const char* key) { return find(*root, key) != nullptr; };
  const bool is_law = has("law") && !has("chain") && !has("network") && !has("body") && !has("bodies");
  return is_law ? Purpose::law : Purpose::simulation;
}

SharedScene make_scene(std::string text, std::string name, scene::Overrides overrides) {
  auto document = scene::parse_document(text, name, overrides);
  auto resolved = resolve(document, purpose_of(document));
  return std::make_shared<const SceneBox>(SceneBox{.text = std::move(text),
                                                   .name = std::move(name),
                                                   .overrides = std::move(overrides),
                                                   .document = std::move(document),
                                                   .scene = std::move(resolved)});
}

SharedScene load(const std::string& path, scene::Overrides overrides) {
  return make_scene(scene::read_text(path), path, std::move(overrides));
}

const char* kind(const SceneBox& box) {
  return std::visit(
      Overload{[](const model::Chain&) { return "chain"; }, [](const model::Network&) { return "network"; },
               [](const model::Microbody&) { return "microbody"; },
               [](const model::Bodies&) { return "bodies"; }, [](const scene::LawAlone&) { return "law"; }},
      box.scene.model);
}

/// A member that chains and networks have.
template <class Get>
py::array of_contacts(const py::object& self, Get get) {
  const auto& model = self.cast<const SceneBox&>().scene.model;
  if (const auto* chain = std::get_if<model::Chain>(&model)) return view(get(*chain), self);
  return view(get(std::get<model::Network>(model)), self);
}

const model::Bodies* bodies(const py::object& self) {
  return std::get_if<model::Bodies>(&self.cast<const SceneBox&>().scene.model);
}

py::array mass(const py::object& self) {
  if (const auto* const many = bodies(self)) return view(many->body, &model::Body::mass, self);
  return view(std::get<model::Chain>(self.cast<const SceneBox&>().scene.model).mass, self);
}

py::array start_velocity(const py::object& self) {
  if (const auto* const many = bodies(self))
    return view(many->body, &model::Body::velocity, many->dimension, self);
  return of_contacts(
      self, [](const auto& model) -> auto& { return model.velocity; });
}

template <Vector3 model::Body::*member>
py::array of_bodies(const py::object& self) {
  const auto& many = std::get<model::Bodies>(self.cast<const SceneBox&>().scene.model);
  return view(many.body, member, many.dimension, self);
}

py::array start_spin(const py::object& self) {
  const auto& many = std::get<model::Bodies>(self.cast<const SceneBox&>().scene.model);
  return view_of_spins(many.body, &model::Body::spin, many.dimension, self);
}

std::string json_text(const SceneBox& box) {
  return report::text(report::json(box.scene));
}

}  // namespace

void add_scene(py::module_& module) {
  py::class_<SceneBox, std::shared_ptr<SceneBox>>(module, "Scene")
      .def_readonly("text", &SceneBox::text)
      .def_readonly("name", &SceneBox::name)
      .def_readonly("overrides", &SceneBox::overrides)
      .def_property_readonly("kind", &kind)
      .def_property_readonly("title", [](const SceneBox& box) { return box.scene.title; })
      .def_property_readonly("warnings", [](const SceneBox& box) { return box.scene.warnings; })
      .def_property_readonly("sha256", [](const SceneBox& box) { return box.scene.sha256; })
      .def_property_readonly("accuracy", [](const SceneBox& box) { return box.scene.run.accuracy; })
      .def_property_readonly("foreign", [](const SceneBox& box) { return !box.own_laws.empty(); })
      .def_property_readonly("mass", &mass)
      .def_property_readonly("velocity", &start_velocity)
      .def_property_readonly("position", &of_bodies<&model::Body::position>)
      .def_property_readonly("spin", &start_spin)
      .def_property_readonly(
          "dimension", [](const SceneBox& box) { return std::get<model::Bodies>(box.scene.model).dimension; })
      .def_property_readonly("gap",
                             [](const py::object& self) {
                               return of_contacts(
                                   self, [](const auto& m) -> auto& { return m.gap; });
                             })
      .def("json", &json_text);
  module.def("scene", &make_scene, py::arg("text"), py::arg("name"), py::arg("overrides"));
  module.def(
      "read_text", [](const std::string& path) { return py::bytes(scene::read_text(path)); },
      py::arg("path"));
  module.def("load", &load, py::arg("path"), py::arg("overrides"));
}

}  // namespace mariotte::python
