// A result as one page that needs nothing else: no network, no other file.
#pragma once
#include <string>
#include <vector>

#include "mariotte/report/json/json.hpp"

namespace mariotte::report {

/// A figure of the page, as SVG.
struct Picture {
  std::string name;
  std::string svg;
};

/// Outcome and checks, the moving picture of `motion` if there is one, figures, then whatever the result
/// holds, of any model: objects and arrays become tables, the middle of a long one left out; at the end the
/// command that repeats the run, and what to cite.
std::string html(const Json& result, const std::vector<Picture>& pictures, const Json& motion = {});

/// The command that repeats a run or a sweep, from its result; empty if the result does not know its scene,
/// or if it is of Python.
std::string repeating_command(const Json& result);

/// What to cite, as BibTeX: this version of the program, with the scene, and the papers of the result's
/// model.
std::string to_cite(const Json& result);

}  // namespace mariotte::report
