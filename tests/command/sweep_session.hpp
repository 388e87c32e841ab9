// Sweeps that are killed and go on.
#pragma once
#include <map>
#include <random>

#include "session.hpp"

namespace support {

/// Six points.
inline const std::string few = std::string(support::three_balls) + R"(
[[sweep]]
key = "chain.velocity[2]"
values = ["-0.5 m/s", 0]
[[sweep]]
key = "chain.mass[1]"
from = 1
to = 3
count = 3
)";

/// A grid of 200 × `columns` triplets of Hertz balls.
inline std::string map_scene(int columns) {
  return std::string(three_balls) + R"([run]
accuracy = 1e-6
[[sweep]]
key = "chain.velocity[2]"
from = -1
to = 0
count = 200
[[sweep]]
key = "chain.mass[1]"
from = 0.5
to = 2
scale = "log"
count = )" +
         std::to_string(columns) + "\n";
}

/// Puts a command on so many ranks. OpenMPI does not give back all it takes, which is no leak of ours.
inline std::string mpirun(int ranks) {
  return "env ASAN_OPTIONS=detect_leaks=0 OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 mpirun "
         "--oversubscribe -n " +
         std::to_string(ranks) + " ";
}

/// A line of shell that starts a sweep into `out` and sends it a signal as soon as its journals have grown,
/// however fast the machine; its code is that of the sweep.
inline std::string struck(const std::string& signal, const std::string& line, const std::string& out) {
  const std::string size = "$(cat " + out + "/*.jsonl 2>/dev/null | wc -c)";
  return "before=" + size + "; " + line + " & until [ " + size +
         " -gt $((before + 5000)) ]; do sleep 0.02; done; kill -s " + signal + " $!; wait $!";
}

/// The journals of a sweep by name, without a last line that is torn.
inline std::map<std::string, std::string> journals(const fs::path& folder) {
  std::map<std::string, std::string> whole;
  if (fs::exists(folder))
    for (const auto& entry : fs::directory_iterator(folder))
      if (const auto name = entry.path().filename().string(); name.ends_with(".jsonl")) {
        const auto text = content(entry.path());
        whole[name] = text.substr(0, text.rfind('\n') + 1);
      }
  return whole;
}

struct Kills {
  int kills = 0;  ///< that struck a running sweep
  int lost = 0;   ///< kills after which a line that had been finished was gone
  bool ended = false;
};

/// Runs a sweep into `out`, killed at random times so many times, and then once without being killed.
inline Kills kill_and_go_on(const Session& session, const std::string& line, const std::string& out,
                            int kills, double longest) {
  std::mt19937 random(1);
  Kills result;
  std::map<std::string, std::string> before;
  const auto compare = [&] {
    const auto now = journals(session.folder / out);
    for (const auto& [name, text] : before)
      result.lost += !now.contains(name) || !now.at(name).starts_with(text);
    before = now;
  };
  for (int i = 0; i < kills; ++i) {
    const double after = longest * std::uniform_real_distribution<double>(0.0, 1.0)(random);
    result.kills += session.shell("timeout -s KILL " + std::to_string(after) + " " + line).code == 137;
    compare();
  }
  result.ended = session.shell(line).code == 0;
  compare();
  return result;
}

}  // namespace support
