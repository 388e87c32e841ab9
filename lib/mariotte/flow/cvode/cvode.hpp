// What results say of SUNDIALS.
#pragma once
#include <string>

namespace mariotte::flow {

/// Version of SUNDIALS at run time, such as "6.4.1".
std::string sundials_version();

}  // namespace mariotte::flow
