// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/cluster/ranks.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <mutex>
#include <thread>
#include <utility>

#include "kinematics/base/result.h"

#ifdef GAITWRIGHT_WITH_MPI
#include <mpi.h>
#endif

namespace gaitwright {

#ifdef GAITWRIGHT_WITH_MPI

bool BuiltWithMpi() { return true; }

namespace {

/// Whether the environment of this process has the rank number that Open MPI, MPICH, PMIx or Slurm sets.
bool Launched() {
  constexpr const char* kNumbers[] = {"OMPI_COMM_WORLD_RANK", "PMI_RANK", "PMIX_RANK"};
  return std::any_of(std::begin(kNumbers), std::end(kNumbers),
                     [](const char* name) { return std::getenv(name) != nullptr; });
}

}  // namespace

struct Ranks::Run {
  int rank = 0, count = 1;
  bool joined = false;
  std::mutex calls;  // only one thread at a time calls MPI

  ~Run() {
    if (joined) MPI_Finalize();
  }
};

Ranks Ranks::Join() {
  auto run = std::make_shared<Run>();
  if (!Launched()) return Ranks(run);
  int given = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &given);
  run->joined = true;
  MPI_Comm_rank(MPI_COMM_WORLD, &run->rank);
  MPI_Comm_size(MPI_COMM_WORLD, &run->count);
  if (given < MPI_THREAD_SERIALIZED && run->count > 1) {
    throw InvalidArgument("this MPI library allows calls from one thread only; MPI_THREAD_SERIALIZED is needed");
  }
  return Ranks(run);
}

void Ranks::Send(int to, const std::string& text) const {
  MPI_Request request;
  {
    const std::lock_guard lock(run_->calls);
    MPI_Isend(text.data(), static_cast<int>(text.size()), MPI_CHAR, to, 0, MPI_COMM_WORLD, &request);
  }
  for (int sent = 0; sent == 0;) {
    {
      const std::lock_guard lock(run_->calls);
      MPI_Test(&request, &sent, MPI_STATUS_IGNORE);
    }
    if (sent == 0) std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
}

std::string Ranks::Receive(int from) const {
  constexpr std::chrono::microseconds kPause(500);
  while (true) {
    {
      const std::lock_guard lock(run_->calls);
      int there = 0, size = 0;
      MPI_Status status;
      MPI_Iprobe(from, 0, MPI_COMM_WORLD, &there, &status);
      if (there != 0) {
        MPI_Get_count(&status, MPI_CHAR, &size);
        std::string text(static_cast<std::size_t>(size), '\0');
        MPI_Recv(text.data(), size, MPI_CHAR, from, 0, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
        return text;
      }
    }
    std::this_thread::sleep_for(kPause);
  }
}

void Ranks::Abort(int status) const {
  if (run_->joined) MPI_Abort(MPI_COMM_WORLD, status);
  std::exit(status);
}

#else

bool BuiltWithMpi() { return false; }

namespace {

/// Whether the launcher of Open MPI, MPICH or Slurm says that there are several processes.
bool LaunchedWithOthers() {
  constexpr const char* kCounts[] = {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"};
  return std::any_of(std::begin(kCounts), std::end(kCounts), [](const char* name) {
    const char* text = std::getenv(name);
    return text != nullptr && std::atoi(text) > 1;
  });
}

}  // namespace

struct Ranks::Run {
  int rank = 0, count = 1;
};

Ranks Ranks::Join() {
  if (LaunchedWithOthers()) {
    throw InvalidArgument(
        "this is one of several processes of an MPI run, but the program was built without MPI; install MPI (Debian: "
        "libopenmpi-dev) and build again");
  }
  return Ranks(std::make_shared<Run>());
}

void Ranks::Send(int, const std::string&) const { throw InvalidArgument("there is no other rank to send to"); }
std::string Ranks::Receive(int) const { throw InvalidArgument("there is no other rank to receive from"); }
void Ranks::Abort(int status) const { std::exit(status); }

#endif

Ranks::Ranks(std::shared_ptr<Run> run) : run_(std::move(run)) {}
int Ranks::rank() const { return run_->rank; }
int Ranks::count() const { return run_->count; }

}  // namespace gaitwright
