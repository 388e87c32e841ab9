#include <fmt/format.h>

#include "command.hpp"
#include "command_line/exit_code.hpp"
#include "command_line/terminal.hpp"
#include "mariotte/report/figure/gnuplot.hpp"
#include "mariotte/report/page/provenance.hpp"

namespace mariotte::command {
namespace {

#ifdef MARIOTTE_MPI
constexpr const char* with_mpi = "yes";
#else
constexpr const char* with_mpi = "none";
#endif

std::string or_none(const std::string& version) {
  return version.empty() ? "none" : version;
}

}  // namespace

Command version_command() {
  return {.name = "version",
          .about = "Version of mariotte and of what it was built with",
          .footer = "Example:\n  mariotte version\n",
          .act = [] {
            const auto program = report::provenance();
            print(fmt::format("mariotte {}\nSUNDIALS {}\ncompiler {}\nbuild {}\n", program.version,
                              program.sundials, program.compiler, program.build_type) +
                  fmt::format("MPI {}\nHDF5 {}\ngnuplot {}\n", with_mpi, or_none(report::hdf5_version()),
                              or_none(report::gnuplot_version())));
            return ExitCode::ok;
          }};
}

}  // namespace mariotte::command
