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

// A track's value at `time_s` by its own interpolation (rotations: unit quaternions xyzw); the first and the last key
// hold outside of them. STEP keeps a key's value until the next key's very time.
dvec4 valueAt(const Track& track, double time_s);

// `time_s` folded into a clip of `duration_s`: itself up to the end, then again from 0.
double clipTime(double time_s, double duration_s);

// Does the clip repeat between two times?
bool beginsAgain(const Animation& clip, double from_s, double to_s);

// Does it come to one of its cuts after the first time, up to the second or at it?
bool comesToACut(const Animation& clip, double from_s, double to_s);

// Whether each number is above the one before.
bool increase(const std::vector<double>& numbers);

// The clips that `animation` ("all", "none" or a name) means. Throws `Error` for an unknown one, naming the nearest.
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
