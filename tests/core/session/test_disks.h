// Disks that fail on purpose.
#pragma once

#include <cerrno>
#include <csignal>

#include "core/session/disk.h"

namespace posecoach {

// Calls `at` before each call that changes the disk, with its number from 1.
class CountingDisk : public Disk {
 public:
  int open(const char* path, int flags, mode_t mode) override {
    return may_go_on() ? Disk::open(path, flags, mode) : -1;
  }
  ssize_t write(int descriptor, const void* bytes, std::size_t size) override {
    return may_go_on() ? Disk::write(descriptor, bytes, size) : -1;
  }
  // A killed process loses nothing that the system has: no need to wait for the platters.
  int fsync(int) override { return may_go_on() ? 0 : -1; }
  int rename(const char* from, const char* to) override { return may_go_on() ? Disk::rename(from, to) : -1; }
  int rename_to_new(const char* from, const char* to) override {
    return may_go_on() ? Disk::rename_to_new(from, to) : -1;
  }
  int exchange(const char* a, const char* b) override {
    if (!may_go_on()) return -1;
    if (can_exchange) return Disk::exchange(a, b);
    return errno = EINVAL, -1;
  }
  int link(const char* from, const char* to) override {
    if (!may_go_on()) return -1;
    if (can_link) return Disk::link(from, to);
    return errno = EPERM, -1;
  }
  int make_folder(const char* path) override { return may_go_on() ? Disk::make_folder(path) : -1; }
  int remove(const char* path) override { return may_remove() ? Disk::remove(path) : -1; }

  int calls = 0;
  bool can_exchange = true, can_link = true;

 protected:
  virtual bool may_go_on() { return ++calls, true; }
  virtual bool may_remove() { return may_go_on(); }
};

// The program dies, without a last word, before its n-th call.
class DyingDisk : public CountingDisk {
 public:
  explicit DyingDisk(int dies_at) : dies_at_(dies_at) {}

 protected:
  bool may_go_on() override {
    if (++calls == dies_at_) ::raise(SIGKILL);
    return true;
  }

 private:
  int dies_at_;
};

// From the n-th call on nothing more fits; what is there can still be removed.
class FillingDisk : public CountingDisk {
 public:
  explicit FillingDisk(int full_at) : full_at_(full_at) {}

 protected:
  bool may_go_on() override {
    if (++calls < full_at_) return true;
    errno = ENOSPC;
    return false;
  }
  bool may_remove() override { return true; }

 private:
  int full_at_;
};

// Half of every write, then the rest: a program must ask again.
class StutteringDisk : public Disk {
 public:
  ssize_t write(int descriptor, const void* bytes, std::size_t size) override {
    if (++calls_ % 3 == 0) return errno = EINTR, -1;
    return Disk::write(descriptor, bytes, (size + 1) / 2);
  }

 private:
  int calls_ = 0;
};

// For tests of many swings, which need not outlive a power cut.
class QuickDisk : public Disk {
 public:
  int fsync(int) override { return 0; }
};

}  // namespace posecoach
