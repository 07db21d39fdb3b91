// How people move from rest to rest, or to a turn: smoothly, with the least jerk (Flash and Hogan 1985). What
// is fitted to a whole way tells when it began or ended better than its first or last millimetre does.
#pragma once

#include <functional>
#include <optional>
#include <vector>

namespace posecoach {

// How much of a way is done after a part of its time: from rest to rest, and from rest to a turn, which is
// swung through without a stop.
double to_rest(double time);
double to_turn(double time);

// Mean square of what values[first..last] differ from the best `offset + size * shape(index)`.
double misfit(const std::vector<double>& values, int first, int last,
              const std::function<double(int)>& shape);

// Which of the rests of `rest` samples that end in [earliest, latest] is best followed by a way to the turn
// at `goal`; where it ends. Nothing where there is no room for one.
std::optional<int> fit_rest_before(const std::vector<double>& values, int earliest, int latest, int goal,
                                   int rest);
// Which of the rests that begin in [earliest, latest] best follows the second half of a way to rest, which
// is in full swing at `moving`; where it begins.
std::optional<int> fit_rest_after(const std::vector<double>& values, int moving, int earliest, int latest,
                                  int rest);

}  // namespace posecoach
