#include "mariotte/impact/sensitivity/notes.hpp"

#include <cstdio>

namespace mariotte::impact {

std::string grazing_note(const std::string& what, double speed, double time) {
  char text[160];
  std::snprintf(text, sizeof text,
                "an event of %s at %.6g s is grazed: its guard crosses zero at %.2g of the natural speed",
                what.c_str(), time, speed);
  return text + std::string("; slopes hold no further than about the square of that from here");
}

std::string shared_ending_note() {
  return "several contacts end the run at one instant, and their times move differently: the slopes of the "
         "time are those of the first, and one-sided";
}

std::string noise_ending_note() {
  return "what ended the run is a motion within its accuracy, so its time has no slopes";
}

}  // namespace mariotte::impact
