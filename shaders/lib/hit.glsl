// SPDX-License-Identifier: MIT
// A point of a surface, named by where it is on the mesh rather than where it is in space: the same point at any time.
#ifndef STROBE_HIT_GLSL
#define STROBE_HIT_GLSL

struct Hit {
  uint instance;      // NO_INSTANCE for a miss
  uint geometry;      // within the instance
  uint primitive;     // triangle within the geometry, in the order of tracing
  vec2 barycentrics;  // weights of the second and third corner
  float t;            // along the ray that found it (view depth, for a camera's ray)
  bool front;         // seen from the side its triangle winds counter-clockwise on
};

struct Ray {
  vec3 origin;
  vec3 direction;  // of a camera's ray: scaled so that t is the view depth
};

Hit noHit() { return Hit(NO_INSTANCE, 0u, 0u, vec2(0), 0.0, true); }

bool isHit(Hit hit) { return hit.instance != NO_INSTANCE; }

#endif
