// One function per alternative of a std::variant, for std::visit: a missing one does not compile.
#pragma once

namespace mariotte {

/// `std::visit(Overload{[](const A&) {…}, [](const B&) {…}}, variant)`.
template <class... Cases>
struct Overload : Cases... {
  using Cases::operator()...;
};
/// The cases say the types.
template <class... Cases>
Overload(Cases...) -> Overload<Cases...>;

}  // namespace mariotte
