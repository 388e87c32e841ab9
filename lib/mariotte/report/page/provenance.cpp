#include "mariotte/report/page/provenance.hpp"

#include "mariotte/flow/cvode/cvode.hpp"
#include "mariotte/version.hpp"

namespace mariotte::report {
namespace {

#if defined(__clang__)
constexpr const char* compiler = __VERSION__;
#elif defined(__GNUC__)
constexpr const char* compiler = "GCC " __VERSION__;
#else
constexpr const char* compiler = "unknown";
#endif

}  // namespace

Provenance provenance() {
  return {.version = version,
          .sundials = flow::sundials_version(),
          .compiler = compiler,
          .build_type = MARIOTTE_BUILD_TYPE};
}

}  // namespace mariotte::report
