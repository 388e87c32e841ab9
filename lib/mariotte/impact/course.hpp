// How solvers of many small impacts go about one.
#pragma once

namespace mariotte::impact {

/// As quickly as possible, or so that the numbers are those of `simulate` to the last bit. Both keep the
/// accuracy.
enum class Course { quickest, of_simulate };

}  // namespace mariotte::impact
