// How a run ends.
#pragma once

namespace mariotte::hybrid {

/// Why a run stopped.
enum class Ending {
  separated,    ///< no contact carries force and no two bodies can meet again
  captured,     ///< a tip has turned back in the well of adhesion
  bound,        ///< adhesion or friction holds bodies for ever; nothing else can meet again
  time_limit,   ///< Options::max_time was reached
  event_limit,  ///< Options::max_events was reached
  interrupted,  ///< whoever looked on gave it up; what was computed until then is kept
  unsure,       ///< it came to an end, but a balance does not close; what was computed is kept
  invalid,      ///< it came to an end, but beyond where any contact law holds; what was computed is kept
  failed        ///< a flow could not go on; what was computed until then is kept
};

/// "separated", "captured", "bound", "time_limit", "event_limit", "interrupted", "unsure", "invalid",
/// "failed".
constexpr const char* name(Ending ending) {
  switch (ending) {
    case Ending::separated:
      return "separated";
    case Ending::captured:
      return "captured";
    case Ending::bound:
      return "bound";
    case Ending::time_limit:
      return "time_limit";
    case Ending::event_limit:
      return "event_limit";
    case Ending::interrupted:
      return "interrupted";
    case Ending::unsure:
      return "unsure";
    case Ending::invalid:
      return "invalid";
    case Ending::failed:
      return "failed";
  }
  return "failed";
}

}  // namespace mariotte::hybrid
