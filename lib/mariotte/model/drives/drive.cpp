#include "mariotte/model/drives/drive.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "mariotte/core/error.hpp"

namespace mariotte::model {
namespace {

bool is_finite(const SignalPiece& p) {
  double sum = p.start + p.amplitude + p.frequency + p.phase;
  for (const double c : p.power) sum += c;
  return std::isfinite(sum) && p.frequency >= 0;
}

void validate_signal(const Signal& signal, std::size_t k) {
  if (signal.piece.empty() || signal.piece.front().start != 0)
    reject_drive(k, "its signal must begin at the time 0");
  for (std::size_t i = 0; i < signal.piece.size(); ++i) {
    if (!is_finite(signal.piece[i])) reject_drive(k, "its signal must be finite");
    if (i > 0 && !(signal.piece[i].start > signal.piece[i - 1].start))
      reject_drive(k, "the pieces of its signal must follow each other");
  }
}

bool names(const ContactDirection& direction, Index dof) {
  return std::any_of(direction.begin(), direction.end(), [&](const Term& term) { return term.dof == dof; });
}

bool has(const Drive& drive, Index dof) {
  return drive.quantity != Driven::force && names(drive.direction, dof);
}

Signal velocity(const Drive& drive) {
  return drive.quantity == Driven::position ? rate(drive.signal) : drive.signal;
}

}  // namespace

void reject_drive(std::size_t k, const char* rule) {
  throw InvalidParameter("drive " + std::to_string(k + 1) + ": " + rule);
}

double start_velocity(const Drive& drive) {
  return drive.quantity == Driven::force ? 0 : value(velocity(drive).piece.front(), 0);
}

double start_force(const Drive& drive) {
  return drive.quantity == Driven::force ? value(drive.signal.piece.front(), 0) : 0;
}

double driven_speed(const Drive& drive, double inverse_mass) {
  const bool pushes = drive.quantity == Driven::force;
  return std::min(drive.reached, pushes ? inverse_mass * largest_integral(drive.signal, drive.until)
                                        : largest(velocity(drive), drive.until));
}

bool prescribes(const std::vector<Drive>& drives, Index dof) {
  return std::any_of(drives.begin(), drives.end(), [&](const Drive& drive) { return has(drive, dof); });
}

bool prescribes(const std::vector<ScaledDrive>& drives, Index dof) {
  return std::any_of(drives.begin(), drives.end(), [&](const ScaledDrive& drive) {
    return !drive.is_force && names(drive.direction, dof);
  });
}

void validate_drive(const std::vector<Drive>& drives, std::size_t k, const std::vector<double>& velocity) {
  const auto& drive = drives[k];
  validate_signal(drive.signal, k);
  if (drive.direction.empty()) reject_drive(k, "it moves nothing");
  for (const auto& [dof, coefficient] : drive.direction) {
    if (dof < 0 || dof >= std::ssize(velocity)) reject_drive(k, "there is no such velocity");
    if (!std::isfinite(coefficient)) reject_drive(k, "its direction must be finite");
    if (drive.quantity == Driven::force) continue;
    if (std::any_of(drives.begin(), drives.begin() + k, [&, i = dof](const Drive& d) { return has(d, i); }))
      reject_drive(k, "its velocity is prescribed by another drive, too");
    if (velocity[dof] != coefficient * start_velocity(drive))
      reject_drive(k, "a velocity at the start is not that of its drive");
  }
}

void expect_end(const std::vector<Drive>& drives, double max_time) {
  if (!drives.empty() && !std::isfinite(max_time))
    throw InvalidParameter("what is driven never comes to an end: give max_time");
}

ScaledDrive in_units(const Drive& drive, ContactDirection response, const Scale& scale) {
  const bool is_force = drive.quantity == Driven::force;
  for (auto& term : response) term.coefficient *= scale.mass;
  ScaledDrive d{.is_force = is_force,
                .direction = drive.direction,
                .response = is_force ? std::move(response) : drive.direction,
                .signal = scaled(is_force ? drive.signal : velocity(drive), scale.time,
                                 is_force ? scale.force() : scale.velocity),
                .change = {}};
  d.change = is_force ? d.signal : rate(d.signal);
  return d;
}

}  // namespace mariotte::model
