#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include "mariotte/impact/sensitivity/law_parameters.hpp"
#include "mariotte/impact/sensitivity/sensitivity.hpp"

namespace mariotte::impact {
namespace {

using model::Bodies;

constexpr double share = 0.01;
constexpr std::size_t few = 12;
constexpr std::array components = {&Vector3::e1, &Vector3::e2, &Vector3::e3};

std::string at(const char* name, std::size_t i) {
  return name + ("[" + std::to_string(i) + "]");
}

double reach(const model::Body& body) {
  double most = 0;
  for (const auto& one : body.spheres) most = std::max(most, norm(one.centre) + one.radius);
  return most;
}

/// What steps are a share of: a length over which geometry changes, a speed.
struct Sizes {
  double length = infinity, speed = 0;
};
Sizes sizes_of(const Bodies& bodies) {
  Sizes sizes;
  for (const auto& body : bodies.body) {
    if (reach(body) > 0) sizes.length = std::min(sizes.length, reach(body));
    sizes.speed = std::max({sizes.speed, norm(body.velocity), norm(body.spin) * reach(body)});
  }
  if (!(sizes.length < infinity)) sizes.length = 1;
  if (sizes.speed == 0) sizes.speed = 1;
  return sizes;
}

/// Parameters that are numbers within the bodies.
class List {
 public:
  explicit List(const Bodies& bodies)
      : shared_(std::make_shared<const Bodies>(bodies)), sizes_(sizes_of(bodies)) {}

  std::vector<Parameter<Bodies>> take() {
    for (std::size_t i = 0; i < shared_->body.size(); ++i) add_body(i);
    const std::size_t contacts = shared_->contact.size();
    for (std::size_t j = 0; j < (contacts > few ? static_cast<std::size_t>(shared_->named) : contacts); ++j)
      add_contact(j);
    add_vector("gravity", dimension::acceleration, [](Bodies& all) -> Vector3& { return all.gravity; });
    return std::move(list_);
  }

 private:
  using Place = std::function<double&(Bodies&)>;
  using VectorPlace = std::function<Vector3&(Bodies&)>;

  double value_at(const Place& place) const {
    auto copy = *shared_;
    return place(copy);
  }
  void add(std::string name, const Dimension& dimension, double step, Place place) {
    const double value = value_at(place);
    const auto move = [shared = shared_, place](double to, Bodies& other) {
      other = *shared;
      place(other) = to;
    };
    list_.push_back({std::move(name), value, step, move, dimension});
  }
  /// By a share of its own value, if that is not zero.
  void add(std::string name, const Dimension& dimension, Place place) {
    const double value = value_at(place);
    if (value != 0) add(std::move(name), dimension, share * std::abs(value), std::move(place));
  }
  void add_vector(const std::string& name, const Dimension& dimension, const VectorPlace& place,
                  double step = 0) {
    for (std::size_t k = 0; k < static_cast<std::size_t>(shared_->dimension); ++k) {
      const Place one = [place, k](Bodies& all) -> double& { return place(all).*components[k]; };
      if (step > 0)
        add(at(name.c_str(), k), dimension, step, one);
      else
        add(at(name.c_str(), k), dimension, one);
    }
  }

  void add_body(std::size_t i) {
    const auto name = at("body", i) + ".";
    const auto of = [i](auto member) {
      return [ i, member ](Bodies & all) -> auto& {
        return all.body[i].*member;
      };
    };
    const double turn = sizes_.speed / std::max(reach(shared_->body[i]), sizes_.length);
    add(name + "mass", dimension::mass, of(&model::Body::mass));
    add_spheres(name, i);
    add_vector(name + "position", dimension::length, of(&model::Body::position), share * sizes_.length);
    add_vector(name + "velocity", dimension::velocity, of(&model::Body::velocity), share * sizes_.speed);
    if (shared_->dimension == 2) {
      add(name + "inertia", dimension::inertia,
          [i](Bodies& all) -> double& { return all.body[i].inertia.e3; });
      add(name + "angle", dimension::none, share, of(&model::Body::angle));
      add(name + "spin", dimension::rate, share * turn,
          [i](Bodies& all) -> double& { return all.body[i].spin.e3; });
    } else {
      add_moments(name + "inertia", i);
      add_vector(name + "spin", dimension::rate, of(&model::Body::spin), share * turn);
    }
  }
  /// Those that are equal move together.
  void add_moments(const std::string& name, std::size_t i) {
    const auto& j = shared_->body[i].inertia;
    if (j.e1 != j.e2 || j.e2 != j.e3)
      return add_vector(name, dimension::inertia,
                        [i](Bodies& all) -> Vector3& { return all.body[i].inertia; });
    const auto move = [shared = shared_, i](double to, Bodies& other) {
      other = *shared;
      other.body[i].inertia = {to, to, to};
    };
    list_.push_back({name, j.e1, share * j.e1, move, dimension::inertia});
  }
  void add_spheres(const std::string& name, std::size_t i) {
    const auto& spheres = shared_->body[i].spheres;
    for (std::size_t k = 0; k < spheres.size(); ++k)
      add(name + (spheres.size() == 1 ? std::string() : at("sphere", k) + ".") + "radius", dimension::length,
          [i, k](Bodies& all) -> double& { return all.body[i].spheres[k].radius; });
  }

  void add_contact(std::size_t j) {
    const auto name = at("contact", j) + ".";
    for (auto& number : law_parameters(shared_->contact[j].law)) {
      if (number.key == "exponent") continue;
      const auto move = [shared = shared_, j, law = std::move(number.law)](double to, Bodies& other) {
        other = *shared;
        other.contact[j].law = law(to);
      };
      list_.push_back({name + number.key, number.value, number.step, move, number.dimension});
    }
    const auto& tangential = shared_->contact[j].tangential;
    if (tangential.law == model::TangentialLaw::none) return;
    const auto of = [j](double model::Tangential::*member) -> Place {
      return [j, member](Bodies& all) -> double& { return all.contact[j].tangential.*member; };
    };
    add(name + "friction", dimension::none, of(&model::Tangential::friction));
    const bool is_spring = tangential.law == model::TangentialLaw::spring;
    const Dimension stiffness =
        is_spring ? Dimension{.kg = 1, .s = -2} : Dimension{.kg = 1, .m = -0.5, .s = -2};
    if (tangential.has_spring())
      add(name + "tangential_stiffness", stiffness, of(&model::Tangential::stiffness));
  }

  std::shared_ptr<const Bodies> shared_;
  Sizes sizes_;
  std::vector<Parameter<Bodies>> list_;
};

}  // namespace

std::vector<Parameter<Bodies>> parameters(const Bodies& bodies) {
  return List(bodies).take();
}

}  // namespace mariotte::impact
