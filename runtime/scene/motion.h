// SPDX-License-Identifier: MIT
// Motion of nodes: keyed tracks, the order of a hierarchy, and the motions of the command line. `Poser` (scene.h)
// computes poses.
#pragma once

#include "scene/scene.h"

namespace strobe::scene {

// Replaces the matrix of a node by translation, rotation, scale and shear, with the same product.
void splitMatrix(Node& node);

// Value of a track at `time_s` by its own interpolation (rotations: unit quaternions xyzw). Before the first key and
// after the last key, the value is constant. STEP keeps the value of a key until exactly the time of the next key.
dvec4 valueAt(const Track& track, double time_s);

// Relative tolerance of equal times. Files store times as floats, which exporters compute as a product of two floats:
// the errors add up to 1.5 * 2^-24 or less.
constexpr double kTimeRounding = 0x1p-22;

// True if the first time is before the second by more than rounding.
bool isBefore(double time_s, double other_s);

// Folds `time_s` into a clip of `duration_s`: unchanged up to the end, then again from 0. A time within rounding of the
// end is the end.
double clipTime(double time_s, double duration_s);

// True if the clip repeats between two times.
bool beginsAgain(const Animation& clip, double from_s, double to_s);

// True if a cut is after the first time and not after the second.
bool comesToACut(const std::vector<double>& cuts, double from_s, double to_s);
// True if a cut of the clip is after the first time and not after the second.
bool comesToACut(const Animation& clip, double from_s, double to_s);

// Value of a track within its clip: at `held_time_s` for a STEP track, at `time_s` for other tracks. Both are times of
// the scene.
dvec4 valueAt(const Animation& clip, const Track& track, double time_s, double held_time_s);

// True if each number is above the previous number.
bool increase(const std::vector<double>& numbers);

// Clips selected by `animation`: "all" clips that do not yield, "none", or the clip of that name. Throws `Error` for an
// unknown clip, with the nearest name.
std::vector<const Animation*> clipsOf(const Scene& scene, const std::string& animation);

// All nodes, parents before children. Throws `Error` naming a node that is its own ancestor.
std::vector<int> hierarchyOrder(const Scene& scene);

// Marks the descendants of marked nodes.
void markDescendants(const Scene& scene, std::vector<bool>& marks);

// World-from-node of every node, at rest.
std::vector<dmat4> restWorlds(const Scene& scene);

// Pose of the instances at rest, without camera and lights.
Pose restPose(const Scene& scene);

// Index of the node `name`. Throws `Error` with the nearest name.
int nodeByName(const Scene& scene, const std::string& name);

// Read the options `NODE=dx,dy,dz` (per frame, world axes) and `NODE=ax,ay,az,degrees` (per frame, about a world axis
// through the node's origin). The node is at rest at `rest_time_s`. Throw `Error` for bad numbers, a zero axis or an
// unknown node.
ConstantMotion moveFromOption(const Scene& scene, const std::string& text, double fps, double rest_time_s);
ConstantMotion spinFromOption(const Scene& scene, const std::string& text, double fps, double rest_time_s);

// Reads `T,T,...`, increasing times in s. An empty text has no times. Throws `Error` (exit code 2) for other texts.
std::vector<double> cutsFromOption(const std::string& text);

}  // namespace strobe::scene
