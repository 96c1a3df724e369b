// SPDX-License-Identifier: MIT
// How nodes move: keyed tracks, the order of a hierarchy, and the motions asked for on the command line.
// The poses themselves are asked of `Poser` (scene.h).
#pragma once

#include "scene/scene.h"

namespace strobe::scene {

// A node's transform in its parts.
struct Transform {
  dvec3 translation = dvec3(0);
  dquat rotation = dquat(1, 0, 0, 0);
  dvec3 scale = dvec3(1);
  dmat4 matrix() const;
};

// Gives a node with a matrix its translation, rotation, scale and shear instead, which make the same matrix.
void splitMatrix(Node& node);

// A track's value at `time_s` by its own interpolation (rotations: unit quaternions xyzw); the first and the last key
// hold outside of them. STEP keeps a key's value until the next key's very time.
dvec4 valueAt(const Track& track, double time_s);

// Times that differ by less than this share of themselves are one time. Files store times as floats, which exporters
// compute as a product of two floats: the errors add up to 1.5 * 2^-24 or less.
constexpr double kTimeRounding = 0x1p-22;

// True if the first time is before the second by more than rounding.
bool isBefore(double time_s, double other_s);

// `time_s` folded into a clip of `duration_s`: itself up to the end, then again from 0. A time within rounding of the
// end is the end.
double clipTime(double time_s, double duration_s);

// True if the clip repeats between two times.
bool beginsAgain(const Animation& clip, double from_s, double to_s);

// True if a cut is after the first time, and before the second or at it.
bool comesToACut(const std::vector<double>& cuts, double from_s, double to_s);
// The same for the cuts of a clip.
bool comesToACut(const Animation& clip, double from_s, double to_s);

// A track's value within its clip: a STEP track's at `held_time_s`, any other's at `time_s`. Both are times of the
// scene.
dvec4 valueAt(const Animation& clip, const Track& track, double time_s, double held_time_s);

// Whether each number is above the one before.
bool increase(const std::vector<double>& numbers);

// The clips that `animation` means: "all" that do not yield, "none", or the one of that name. Throws `Error` for an
// unknown one, naming the nearest.
std::vector<const Animation*> clipsOf(const Scene& scene, const std::string& animation);

// All nodes, parents before children. Throws `Error` naming a node that is its own ancestor.
std::vector<int> hierarchyOrder(const Scene& scene);

// World from node at rest, of every node.
std::vector<dmat4> restWorlds(const Scene& scene);

// Instances at rest; without camera and lights.
Pose restPose(const Scene& scene);

// The index of the node called `name`. Throws `Error` with the nearest name.
int nodeByName(const Scene& scene, const std::string& name);

// `NODE=dx,dy,dz` (per frame, world axes) and `NODE=ax,ay,az,degrees` (per frame about a world axis through the node's
// origin), at rest at `rest_time_s`. Throw `Error` for bad numbers, a zero axis or an unknown node.
ConstantMotion moveFromOption(const Scene& scene, const std::string& text, double fps, double rest_time_s);
ConstantMotion spinFromOption(const Scene& scene, const std::string& text, double fps, double rest_time_s);

// `T,T,...`, seconds that increase; of an empty text none. Throws `Error` (exit code 2) for others.
std::vector<double> cutsFromOption(const std::string& text);

}  // namespace strobe::scene
