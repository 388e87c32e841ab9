#include "lammps.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <span>
#include <sstream>

#include "lammps_cases.hpp"
#include "mariotte/impact/bodies/bodies_impact.hpp"
#include "mariotte/impact/chain/chain_solver.hpp"
#include "mariotte/report/page/files.hpp"

namespace mariotte::work_precision {
namespace {

using model::Bodies;

const hybrid::Options options{.accuracy = 1e-10, .max_time = 1};

/// Velocities in the plane and spins of both balls.
struct End {
  std::array<double, 6> value;
  double seconds = 0;
};

std::string ball(const Bodies& bodies, std::size_t i) {
  const auto& one = bodies.body[i];
  const auto number = i + 1;
  auto text = fmt::format("create_atoms 1 single {:.17g} 0 0\n", one.position.e1);
  text +=
      fmt::format("set atom {} diameter {:.17g} mass {:.17g} vx {:.17g} vy {:.17g} omega 0 0 {:.17g}\n",
                  number, 2 * one.spheres[0].radius, one.mass, one.velocity.e1, one.velocity.e2, one.spin.e3);
  return text;
}

std::string input(const LammpsCase& one, double step, long steps) {
  std::string text =
      "units si\natom_style sphere\natom_modify map array\nboundary f f f\nnewton off\ncomm_modify vel yes\n"
      "region box block -1 1 -1 1 -1 1\ncreate_box 1 box\n";
  for (std::size_t i = 0; i < one.bodies.body.size(); ++i) text += ball(one.bodies, i);
  text += "neighbor 0.01 bin\npair_style granular\npair_coeff 1 1 " + one.pair_coeff + "\n";
  text += fmt::format("timestep {:.17g}\nfix 1 all nve/sphere\ncompute w all property/atom omegaz\n", step);
  text += "variable a equal vx[1]\nvariable b equal vy[1]\nvariable c equal c_w[1]\n";
  text += "variable d equal vx[2]\nvariable e equal vy[2]\nvariable f equal c_w[2]\n";
  text += fmt::format("thermo_style custom step v_c v_f\nthermo 0\nrun {}\n", steps);
  return text +
         "print \"END $(v_a:%.17g) $(v_b:%.17g) $(v_c:%.17g) $(v_d:%.17g) $(v_e:%.17g) $(v_f:%.17g)\"\n";
}

/// The numbers after a word at the start of a line.
bool numbers_after(const std::string& text, const std::string& word, std::span<double> numbers) {
  const auto at = text.find("\n" + word);
  std::istringstream rest(at == std::string::npos ? "" : text.substr(at + 1 + word.size()));
  for (double& one : numbers) rest >> one;
  return static_cast<bool>(rest);
}

End by_lammps(const LammpsCase& one, double step, long steps) {
  const auto file = std::filesystem::temp_directory_path() / fmt::format("mariotte-lammps-{}.in", ::getpid());
  report::write_file(file.string(), input(one, step, steps));
  std::string said;
  std::FILE* const pipe = ::popen(fmt::format("lmp -log none -in {} 2>&1", file.string()).c_str(), "r");
  for (int c = 0; pipe && (c = std::fgetc(pipe)) != EOF;) said += static_cast<char>(c);
  if (pipe) ::pclose(pipe);
  std::filesystem::remove(file);
  End end;
  if (!numbers_after(said, "END", end.value) || !numbers_after(said, "Loop time of", {&end.seconds, 1}))
    throw Error("LAMMPS says: " + said.substr(std::min(said.find("ERROR"), said.size()), 300));
  return end;
}

/// Balls that meet head on are a chain.
End of_chain(const Bodies& bodies, const measuring::Patience& patience) {
  const auto &a = bodies.body[0], &b = bodies.body[1];
  const model::Chain chain{.mass = {a.mass, b.mass},
                           .law = {bodies.contact[0].law},
                           .gap = {0},
                           .velocity = {a.velocity.e1, b.velocity.e1}};
  impact::ChainSolver solver;
  const auto run = [&] { solver.solve(chain, options); };
  const double seconds = measuring::least_seconds(run, measuring::timed(run), patience);
  const auto& end = solver.solve(chain, options).velocity;
  return {{end[0], 0, 0, end[1], 0, 0}, seconds};
}

End of_bodies(const Bodies& bodies, const measuring::Patience& patience) {
  const auto run = [&] { impact::simulate(bodies, options); };
  const double seconds = measuring::least_seconds(run, measuring::timed(run), patience);
  const auto found = impact::simulate(bodies, options);
  const auto &a = found.body[0], &b = found.body[1];
  return {{a.velocity.e1, a.velocity.e2, a.spin.e3, b.velocity.e1, b.velocity.e2, b.spin.e3}, seconds};
}

double difference(const End& one, const End& other, double radius) {
  double most = 0;
  for (std::size_t i = 0; i < one.value.size(); ++i)
    most = std::max(most, std::abs(one.value[i] - other.value[i]) * (i % 3 == 2 ? radius : 1));
  return most;
}

std::string lines(const LammpsCase& one, const measuring::Patience& patience) {
  const bool slips = one.bodies.contact[0].tangential.law != model::TangentialLaw::none;
  const auto exact = slips ? of_bodies(one.bodies, patience) : of_chain(one.bodies, patience);
  const double duration = *impact::simulate(one.bodies, options).contacts[0].periods[0].end;
  double before = NAN;
  std::string text;
  for (const long steps : {100L, 400L, 1600L, 6400L}) {
    const auto end = by_lammps(one, duration / static_cast<double>(steps), steps + steps / 10);
    const double error = difference(end, exact, one.bodies.body[0].spheres[0].radius);
    text += fmt::format("{:<20}  {:>6}  {:>8.1e}  {:>5}  {:>10.0f}  {:>11.1f}\n", one.name, steps, error,
                        before > 0 ? fmt::format("{:.1f}", std::log(before / error) / std::log(4.0)) : "–",
                        1e6 * end.seconds, 1e6 * exact.seconds);
    before = error;
  }
  return text;
}

}  // namespace

std::string beside_lammps(const measuring::Patience& patience) {
  if (std::system("lmp -h > /dev/null 2>&1") != 0) return "LAMMPS (lmp) is not installed.\n";
  std::string text = "pair                   steps     error  order   LAMMPS/µs  mariotte/µs\n";
  for (const auto& one : lammps_cases()) {
    std::fprintf(stderr, "%s by LAMMPS\n", one.name.c_str());
    text += lines(one, patience);
  }
  return text;
}

}  // namespace mariotte::work_precision
