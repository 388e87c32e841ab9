// What happens in a contact of bodies with friction.
#pragma once
#include <cstddef>

namespace mariotte::model {

/// What a contact says at an event.
enum class BodyEvent { close, open, touch, part, stick, slip, reverse, load, unload, slack, grip, yield };
/// How many there are.
inline constexpr std::size_t body_events = 12;

}  // namespace mariotte::model
