#include "mariotte/scene/layout.hpp"

#include <algorithm>
#include <array>

#include "mariotte/scene/error_list.hpp"

namespace mariotte::scene {
namespace {

#ifdef FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION  // a fuzzer has better to do than to read a million balls
constexpr Index most_balls = 1000;
#else
constexpr Index most_balls = 10'000'000;
#endif
constexpr std::array<std::string_view, 3> sides{"left", "right", "both"};
constexpr std::array<std::string_view, 5> per_ball{"mass", "radius", "diameter", "material", "velocity"};
constexpr std::array<std::string_view, 7> per_contact{"gap",      "law",         "stiffness", "damping",
                                                      "exponent", "restitution", "at"};

Index size(const Field& array) {
  return static_cast<Index>(array.node->array()->size());
}

std::optional<Field> find_array(const Field& chain, std::string_view key) {
  auto field = find(chain, key);
  return field && field->node->array() ? field : std::nullopt;
}

std::optional<Index> infer_contacts(const Field& chain) {
  for (const auto key : per_contact)
    if (const auto array = find_array(chain, key)) return size(*array);
  const auto contacts = find_array(chain, "contact");
  // A single [[chain.contact]] stands for all contacts and tells nothing, nor do some with numbers.
  const bool tells = contacts && size(*contacts) > 1 && !find(element(*contacts, 0), "number");
  return tells ? std::optional(size(*contacts)) : std::nullopt;
}

/// Balls by the first array of their properties.
std::optional<Index> infer_balls(const Field& chain) {
  for (const auto key : per_ball)
    if (const auto array = find_array(chain, key)) return size(*array);
  return {};
}

/// Balls that are repeated: as many as the first array of their properties has.
Index count_cell(const Source& source, const Field& chain, const Field& repeat) {
  if (find(chain, "balls"))
    reject(source, repeat, fault::contradiction, "'balls' is given, too; give one of them");
  for (const auto key : per_ball)
    if (const auto array = find_array(chain, key); array && key != "velocity") return size(*array);
  return 1;
}

Index count_balls(const Source& source, const Field& chain, Index walls) {
  if (const auto balls = find(chain, "balls")) return whole(source, *balls, 1, most_balls);
  if (const auto balls = infer_balls(chain)) return *balls;
  if (const auto contacts = infer_contacts(chain)) return *contacts + 1 - walls;
  reject(source, chain, fault::missing, "how many balls? Give 'balls', or an array with one value per ball");
}

void read_walls(const Source& source, const Field& chain, Layout& layout) {
  const auto wall = find(chain, "wall");
  if (!wall) return;
  const auto side = sides[choice(source, *wall, "wall", sides)];
  layout.left = side != "right";
  layout.right = side != "left";
}

void read_counts(const Source& source, const Field& chain, Layout& layout) {
  if (const auto repeat = find(chain, "repeat")) {
    layout.cell = count_cell(source, chain, *repeat);
    layout.listed = layout.cell * whole(source, *repeat, 1, most_balls);
  } else {
    layout.cell = layout.listed = count_balls(source, chain, layout.left + layout.right);
  }
}

void expect_size(const Source& source, const Field& array, Index wanted, const std::string& things) {
  if (size(array) != wanted)
    reject(source, array, fault::wrong_length,
           "needs one value per " + things + " (" + std::to_string(wanted) + "), got " +
               std::to_string(size(array)));
}

}  // namespace

Layout read_layout(const Source& source, const Field& chain) {
  Layout layout;
  ErrorList errors;
  errors.attempt([&] { read_walls(source, chain, layout); });
  errors.attempt([&] { read_counts(source, chain, layout); });
  errors.raise();
  if (layout.listed < 1 || layout.balls() < 2 || layout.listed > most_balls)
    reject(source, chain, fault::out_of_range,
           "a chain has from two balls (or a ball and a wall) to ten million");
  return layout;
}

Layout guess_layout(const Field& chain) {
  const Index by_contacts = infer_contacts(chain).value_or(1) + 1;
  const Index balls = std::max<Index>(2, infer_balls(chain).value_or(by_contacts));
  return {.cell = balls, .listed = balls};
}

void expect_per_ball(const Source& source, const Field& array, const Layout& layout) {
  const bool walls = layout.left || layout.right;
  expect_size(source, array, layout.listed, walls ? "ball that is no wall" : "ball");
}

void expect_per_cell(const Source& source, const Field& array, const Layout& layout) {
  if (layout.cell == layout.listed) return expect_per_ball(source, array, layout);
  expect_size(source, array, layout.cell, "ball that is repeated");
}

void expect_per_contact(const Source& source, const Field& array, const Layout& layout) {
  const bool walls = layout.left || layout.right;
  expect_size(source, array, layout.contacts(), walls ? "contact, those of the walls included" : "contact");
}

}  // namespace mariotte::scene
