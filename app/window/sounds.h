// Short tones for the hands-free loop, for ears that stand three metres from the screen. Without a sound
// device: silence, no error.
#pragma once

#include <memory>

namespace posecoach {

enum class Tone { Ready, Swing, Answer, Trouble };

class Sounds {
 public:
  Sounds();
  ~Sounds();
  Sounds(const Sounds&) = delete;
  Sounds& operator=(const Sounds&) = delete;

  bool has_device() const;
  void play(Tone tone);  // returns at once

 private:
  class Player;
  std::unique_ptr<Player> player_;
};

}  // namespace posecoach
