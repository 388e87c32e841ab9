// Impact laws on plain numbers, and contact laws from outside.
#include <pybind11/stl.h>

#include <algorithm>

#include "arrays.hpp"
#include "bindings.hpp"
#include "mariotte/impact/laws/multiple_impact_law.hpp"
#include "mariotte/impact/laws/rival_laws.hpp"
#include "scene_box.hpp"

namespace mariotte::python {
namespace {

using Values = std::vector<double>;

/// Status, reason, velocities, impulses, energy ratios in the given frame and of the mass centre, and the
/// least one that there is.
py::tuple outcome(impact::LawOutcome made) {
  const std::string status = name(made.status), why = reason(made);
  const auto balls = std::ssize(made.velocity), contacts = std::ssize(made.impulse);
  return py::make_tuple(status, why, owned(std::move(made.velocity), {balls}),
                        owned(std::move(made.impulse), {contacts}), or_nan(made.ratio_lab),
                        or_nan(made.ratio_centre), or_nan(made.least_energy_ratio));
}

py::tuple multiple_impact_law(const Values& mass, const Values& velocity, const Values& direction,
                              double energy_ratio, bool mass_centre) {
  using impact::EnergyFrame;
  return outcome(multiple_impact(impact::chain_configuration(mass, velocity),
                                 {.direction = direction,
                                  .energy_ratio = energy_ratio,
                                  .frame = mass_centre ? EnergyFrame::mass_centre : EnergyFrame::given}));
}

py::dict rival_laws(const Values& mass, const Values& velocity, double restitution, const Values& stiffness,
                    double exponent, const Values& direction) {
  py::dict all;
  const auto contacts = std::max<std::size_t>(1, mass.size()) - 1;
  for (const auto& [name, made] :
       rival_outcomes(impact::chain_configuration(mass, velocity), {.restitution = restitution,
                                                                   .stiffness = stiffness,
                                                                   .exponent = Values(contacts, exponent),
                                                                   .direction = direction}))
    all[py::str(name)] = outcome(made);
  return all;
}

/// A reference that any thread may let go, even after the interpreter has ended.
std::shared_ptr<const void> keep(py::object one) {
  return {new py::object(std::move(one)), [](const py::object* kept) {
            if (!Py_IsInitialized()) return;
            const py::gil_scoped_acquire lock;
            delete kept;
          }};
}

/// A law that somebody else has compiled: functions of C by their addresses, which live as long as `owner`.
class ForeignLaw final : public contact::CustomLaw {
 public:
  using ForceOf = void (*)(double indentation, double rate, double* force_and_slopes);
  using EnergyOf = double (*)(double indentation);

  ForeignLaw(std::string name, std::uintptr_t force, std::uintptr_t energy, bool dissipates,
             std::shared_ptr<const void> owner)
      : name_(std::move(name)),
        force_(reinterpret_cast<ForceOf>(force)),
        energy_(reinterpret_cast<EnergyOf>(energy)),
        dissipates_(dissipates),
        owner_(std::move(owner)) {}

  std::string_view name() const override { return name_; }
  contact::Force force(double indentation, double rate) const override {
    double out[3] = {};
    force_(indentation, rate, out);
    return {.value = out[0], .by_indentation = out[1], .by_rate = out[2]};
  }
  double stored_energy(double indentation) const override { return energy_(indentation); }
  bool dissipates() const override { return dissipates_; }

 private:
  std::string name_;
  ForceOf force_;
  EnergyOf energy_;
  bool dissipates_;
  std::shared_ptr<const void> owner_;
};

/// "cone at contacts 1, 3", of contacts from 0.
std::string law_at(const std::string& name, const std::vector<Index>& contacts) {
  std::string numbers;
  for (const Index j : contacts) numbers += (numbers.empty() ? " " : ", ") + std::to_string(j + 1);
  return name + (contacts.size() == 1 ? " at contact" : " at contacts") + numbers;
}

/// The scene with this law at the contacts, from 0.
SharedScene with_law(const SceneBox& box, const std::string& name, std::uintptr_t force,
                     std::uintptr_t energy, bool dissipates, const std::vector<Index>& contacts,
                     py::object owner) {
  auto made = std::make_shared<SceneBox>(box);
  const auto law =
      std::make_shared<const ForeignLaw>(name, force, energy, dissipates, keep(std::move(owner)));
  auto* const chain = std::get_if<model::Chain>(&made->scene.model);
  auto* const network = std::get_if<model::Network>(&made->scene.model);
  if (!chain && !network) throw InvalidParameter("only contacts of chains and networks take a law");
  auto& laws = chain ? chain->law : network->law;
  for (const Index j : contacts) {
    if (j < 0 || j >= std::ssize(laws)) throw py::index_error("no contact " + std::to_string(j));
    laws[static_cast<std::size_t>(j)] = law;
  }
  made->own_laws.push_back(law_at(name, contacts));
  made->scene.sha256.clear();  // that of another scene
  return made;
}

}  // namespace

void add_laws(py::module_& module) {
  module.def("multiple_impact_law", &multiple_impact_law, py::arg("mass"), py::arg("velocity"),
             py::arg("direction"), py::arg("energy_ratio"), py::arg("mass_centre"));
  module.def("direction_of_ratios", &impact::direction_of_ratios, py::arg("icr"));
  module.def("rival_laws", &rival_laws, py::arg("mass"), py::arg("velocity"), py::arg("restitution"),
             py::arg("stiffness"), py::arg("exponent"), py::arg("direction"));
  module.def("with_law", &with_law, py::arg("scene"), py::arg("name"), py::arg("force"), py::arg("energy"),
             py::arg("dissipates"), py::arg("contacts"), py::arg("owner"));
}

}  // namespace mariotte::python
