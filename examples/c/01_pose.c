/* From C: the pose of matches, most of them wrong, and the pose of two clouds of floats. */
#include <gmcr.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { kMatches = 400, kRight = 60, kPoints = 4000 };

/* The same numbers everywhere, in [0, 1). */
static double draw(unsigned* state) {
  *state = *state * 1664525u + 1013904223u;
  return *state / 4294967296.0;
}

/* A turn of 0.5 about z, then a shift. */
static void move(const double* from, double* to) {
  to[0] = cos(0.5) * from[0] - sin(0.5) * from[1] + 0.3;
  to[1] = sin(0.5) * from[0] + cos(0.5) * from[1] - 0.2;
  to[2] = from[2] + 0.1;
}

/* What a program does with a result: 0 where it has a pose to rely on. */
static int report(const char* what, const gmcr_result* result) {
  double pose[16];
  size_t num_inliers = 0;
  ptrdiff_t lower = 0, upper = 0;
  if (gmcr_result_error(result) != GMCR_SUCCESS) {
    fprintf(stderr, "%s: %s\n", what, gmcr_result_message(result));
    return 2;
  }
  gmcr_result_pose(result, pose);
  gmcr_result_inliers(result, &num_inliers);
  gmcr_result_certificate(result, &lower, &upper);
  printf("%s: %s, %zu inliers, at most %td\n", what, gmcr_result_verdict_reason(result),
         num_inliers, upper);
  for (int row = 0; row < 4; ++row) {
    printf("  %9.4f %9.4f %9.4f %9.4f\n", pose[4 * row], pose[4 * row + 1], pose[4 * row + 2],
           pose[4 * row + 3]);
  }
  if (gmcr_result_status(result) != GMCR_OK || gmcr_result_verdict(result) != GMCR_TRUSTED)
    return 1;
  return fabs(pose[0] - cos(0.5)) < 0.02 && fabs(pose[3] - 0.3) < 0.02 ? 0 : 1;
}

static int matches_to_pose(void) {
  static double source[3 * kMatches], target[3 * kMatches];
  unsigned state = 1;
  for (int i = 0; i < kMatches; ++i) {
    for (int axis = 0; axis < 3; ++axis) source[3 * i + axis] = draw(&state);
    move(source + 3 * i, target + 3 * i);
    for (int axis = 0; axis < 3; ++axis) {
      double* coordinate = target + 3 * i + axis;
      *coordinate = i < kRight ? *coordinate + 0.002 * (draw(&state) - 0.5) : draw(&state);
    }
  }
  gmcr_options* options = gmcr_options_new();
  if (gmcr_options_set_number(options, "noise_bound", 0.005) != GMCR_SUCCESS) {
    fprintf(stderr, "%s\n", gmcr_options_message(options));
  }
  const gmcr_points a = {source, kMatches, 0, GMCR_FLOAT64};
  const gmcr_points b = {target, kMatches, 0, GMCR_FLOAT64};
  gmcr_result* result = gmcr_register_correspondences(a, b, options);
  const int code = report("matches", result);
  gmcr_result_free(result);
  gmcr_options_free(options);
  return code;
}

/* As sensors give it: x, y and z beside something else. */
typedef struct {
  float x, y, z, intensity;
} point;

static int clouds_to_pose(void) {
  static point source[kPoints], target[kPoints];
  unsigned state = 2;
  for (int i = 0; i < kPoints; ++i) {
    const double u = draw(&state), v = draw(&state);
    const double bump = exp(-30 * (u - 0.3) * (u - 0.3) - 40 * v * v);
    const double here[3] = {u, v, 0.25 * sin(7 * u) * cos(5 * v) + 0.2 * bump};
    double there[3];
    move(here, there);
    source[i] = (point){(float)here[0], (float)here[1], (float)here[2], 1};
    target[i] = (point){(float)there[0], (float)there[1], (float)there[2], 1};
  }
  const gmcr_points a = {source, kPoints, sizeof(point), GMCR_FLOAT32};
  const gmcr_points b = {target, kPoints, sizeof(point), GMCR_FLOAT32};
  gmcr_result* result = gmcr_register_clouds(a, b, NULL);
  const int code = report("clouds", result);
  gmcr_result_free(result);
  return code;
}

int main(void) {
  printf("gmcr %s\n", gmcr_version());
  const int of_matches = matches_to_pose(), of_clouds = clouds_to_pose();
  return of_matches != 0 ? of_matches : of_clouds;
}
