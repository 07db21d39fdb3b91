// The people who practise: one plain file each, remembered between runs.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/body/mirror.h"
#include "core/body/skeleton.h"
#include "core/session/disk.h"

namespace posecoach {

struct Person {
  std::string name;                     // as typed; two people differ in more than case, accents and spaces
  std::optional<Handedness> hand;       // not known: detected
  std::optional<double> height_m;       // stature; scales what a webcam measures
  std::optional<Skeleton> body;         // measured
  std::string coach = "bundled:swing";  // as `--coach` takes it: a reference's source (references.h)
  double strictness = 1;                // of the score: 0.5 kind, 1, 2 hard
  std::string last_view = "face-on";    // or "down-the-line"
};

// The person's folder: people/anna/person.json ("posecoach.person/1") with anna's body beside it, body.json
// ("posecoach.body/1"). One broken profile does not hide the others.
class People {
 public:
  explicit People(std::filesystem::path folder, Disk& disk = system_disk())
      : folder_(std::move(folder)), disk_(disk) {}

  struct Listed {
    Person person;           // only the name where it is unreadable
    std::string unreadable;  // why; empty otherwise
  };
  // By name. A folder that is missing means nobody.
  std::vector<Listed> list() const;
  // By name, letter case and accents aside. Errors: NotFound, naming those that there are; Malformed.
  Result<Person> find(std::string_view name) const;
  // New or changed; keys that this version does not know stay. Errors: InvalidArgument (a name without
  // letters, a height or strictness out of range, a name too like another's), Unreadable.
  Result<void> save(const Person& person);
  // The profile, not the swings. Errors: NotFound, Unreadable.
  Result<void> remove(std::string_view name);

  // Who practises when nobody was chosen: `last` where there is such a profile, else the only or first one,
  // else somebody new by the name of "Golfer".
  Person default_person(std::string_view last) const;

 private:
  std::filesystem::path folder_;
  Disk& disk_;
};

}  // namespace posecoach
