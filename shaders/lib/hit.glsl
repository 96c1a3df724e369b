// SPDX-License-Identifier: MIT
// Hit of a ray: a surface point, stored as a place on the mesh instead of a position in space, so that the point can be posed
// at any time. This file also declares the type of a ray.
#ifndef STROBE_HIT_GLSL
#define STROBE_HIT_GLSL

struct Hit {
  uint instance;      // NO_INSTANCE for a miss
  uint geometry;      // within the instance
  uint primitive;     // number of the triangle within the geometry
  vec2 barycentrics;  // weights of the second and third corner
  float t;            // distance along the ray that found the hit; for a camera's ray: view depth, metres
  bool front;         // hit on the front, where the corners run counter-clockwise
};

struct Ray {
  vec3 origin;
  vec3 direction;  // a camera's ray: scaled so that t is the view depth
};

Hit noHit() { return Hit(NO_INSTANCE, 0u, 0u, vec2(0), 0.0, true); }

bool isHit(Hit hit) { return hit.instance != NO_INSTANCE; }

#endif
