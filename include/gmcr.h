/** @file
 * @brief gmcr for C, and for what calls C: link gmcr::c, or `pkg-config --libs gmcr-c`.
 *
 *     gmcr_options* options = gmcr_options_new();
 *     gmcr_options_set_number(options, "noise_bound", 0.05);
 *     gmcr_result* result = gmcr_register_correspondences(source, target, options);
 *     if (gmcr_result_error(result)) fprintf(stderr, "%s\n", gmcr_result_message(result));
 *     gmcr_result_free(result);
 *     gmcr_options_free(options);
 *
 * Nothing is printed, no exception leaves, and there is no state but in these two objects.
 * Different threads may work on different objects, and read the same one. Whatever is said of data,
 * units, cost and determinism in gmcr/registration.hpp and gmcr/frontend.hpp holds here too. */
#ifndef GMCR_H
#define GMCR_H

#include <stddef.h>

#if defined(__GNUC__)
#define GMCR_C_API __attribute__((visibility("default")))
#else
#define GMCR_C_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** Why a call did nothing. */
typedef enum gmcr_error {
  GMCR_SUCCESS = 0,
  GMCR_INVALID_ARGUMENT =
      1, /**< the caller's mistake; the message names the argument and its value */
  GMCR_OUT_OF_MEMORY = 2,
  GMCR_FAILURE = 3 /**< anything else; the message says what */
} gmcr_error;

/** What a solve came to. */
typedef enum gmcr_status {
  GMCR_OK = 0, /**< there is a pose */
  GMCR_TOO_FEW_CORRESPONDENCES = 1,
  GMCR_NO_CONSENSUS = 2,
  GMCR_DEGENERATE = 3 /**< the pose is one of many that fit */
} gmcr_status;

/** How far the pose can be relied on. */
typedef enum gmcr_verdict { GMCR_TRUSTED = 0, GMCR_DOUBTFUL = 1, GMCR_UNTRUSTED = 2 } gmcr_verdict;

/** How a pose graph wants a covariance; see PoseGraph in gmcr/result.hpp. */
typedef enum gmcr_pose_graph {
  GMCR_GTSAM = 0, /**< rotation, then translation, of T in T Exp(xi), source frame */
  GMCR_ROS = 1    /**< translation, then rotation about the axes of the target frame */
} gmcr_pose_graph;

/** Type of the numbers of `gmcr_points`. */
typedef enum gmcr_number { GMCR_FLOAT64 = 0, GMCR_FLOAT32 = 1 } gmcr_number;

/** Points in the caller's memory, metres: x, y and z of a point are three numbers one after the
 * other. */
typedef struct gmcr_points {
  const void* data; /**< the x of the first point; may be NULL where there are none */
  size_t count;     /**< points */
  size_t stride; /**< bytes from the x of a point to that of the next; 0: they are three numbers */
  gmcr_number type; /**< of the numbers */
} gmcr_points;

/** Options of both ways to register. */
typedef struct gmcr_options gmcr_options;

/** What a registration found, or why it did nothing. */
typedef struct gmcr_result gmcr_result;

/** "0.2.0" */
GMCR_C_API const char* gmcr_version(void);

/** The defaults. NULL where there is no memory. To be freed. */
GMCR_C_API gmcr_options* gmcr_options_new(void);

/** Of NULL nothing is freed. */
GMCR_C_API void gmcr_options_free(gmcr_options* options);

/** Sets an option that is a number, a whole number, or a switch, which is 0 or 1.
 *
 * An option has the name that it has in C++, in Python and in JSON (docs/json.md); those of two
 * clouds, such as "voxel_size", are there too, and so are "gravity.max_tilt" and the like. What is
 * set is checked when it is used. GMCR_INVALID_ARGUMENT where there is no such option or it takes
 * something else, and the option stays as it was. */
GMCR_C_API gmcr_error gmcr_options_set_number(gmcr_options* options, const char* name,
                                              double value);

/** Sets an option that is a choice, such as "scale_mode" to "estimated"; all else as in
 * gmcr_options_set_number(). */
GMCR_C_API gmcr_error gmcr_options_set_word(gmcr_options* options, const char* name,
                                            const char* word);

/** Sets an option that is a list, a range or a vector, such as "scale_range" (2 numbers),
 * "gravity.source" (3), "noise_bounds" (one a correspondence) or
 * "initial_pose.target_from_source" (4 rows of 4); all else as in gmcr_options_set_number(). */
GMCR_C_API gmcr_error gmcr_options_set_numbers(gmcr_options* options, const char* name,
                                               const double* values, size_t count);

/** Called now and then from the thread that called the solver, with the name of the stage and the
 * share of it that is done; 0 stops the search, which then ends as if its time were up. */
typedef int (*gmcr_progress)(const char* stage, double fraction, void* user);

/** `progress` is called with `user`. NULL: nothing is. */
GMCR_C_API gmcr_error gmcr_options_set_progress(gmcr_options* options, gmcr_progress progress,
                                                void* user);

/** What was wrong in the last call that set an option; "" where nothing was. */
GMCR_C_API const char* gmcr_options_message(const gmcr_options* options);

/** The pose that most of the putative correspondences source[i] -> target[i] agree with. Both have
 * as many points. `options` needs "noise_bound", "noise_bounds", or "noise_mode" "estimated".
 * Returns an object to be freed, whatever happens; NULL where there was no memory for one. */
GMCR_C_API gmcr_result* gmcr_register_correspondences(gmcr_points source, gmcr_points target,
                                                      const gmcr_options* options);

/** The pose that aligns two clouds, from no initial guess. `options` may be NULL: the defaults. */
GMCR_C_API gmcr_result* gmcr_register_clouds(gmcr_points source, gmcr_points target,
                                             const gmcr_options* options);

/** Of NULL nothing is freed. */
GMCR_C_API void gmcr_result_free(gmcr_result* result);

/** What was wrong with the call that returned this result.
 *
 * Whatever reads a result takes NULL too, for one that found no memory. After an error there is no
 * pose, and nothing else. */
GMCR_C_API gmcr_error gmcr_result_error(const gmcr_result* result);
GMCR_C_API const char* gmcr_result_message(const gmcr_result* result); /**< of the error, or "" */

/** Whether there is a pose; GMCR_TOO_FEW_CORRESPONDENCES after an error. */
GMCR_C_API gmcr_status gmcr_result_status(const gmcr_result* result);
GMCR_C_API const char* gmcr_result_status_reason(
    const gmcr_result* result); /**< "" where GMCR_OK */

/** Whether it may be used; GMCR_UNTRUSTED after an error. */
GMCR_C_API gmcr_verdict gmcr_result_verdict(const gmcr_result* result);
GMCR_C_API const char* gmcr_result_verdict_reason(const gmcr_result* result); /**< a sentence */

/** target_from_source: 4 rows of 4, scale times rotation and translation; the identity where there
 * is no pose. */
GMCR_C_API void gmcr_result_pose(const gmcr_result* result, double matrix[16]);

/** > 0, no unit; 1 where there is no pose. */
GMCR_C_API double gmcr_result_scale(const gmcr_result* result);

/** Indices of the correspondences that agree, ascending; they live as long as the result. Of two
 * clouds: of matches that were made on the way. */
GMCR_C_API const ptrdiff_t* gmcr_result_inliers(const gmcr_result* result, size_t* count);

/** `lower` inliers are achieved, no pose has more than `upper`. */
GMCR_C_API void gmcr_result_certificate(const gmcr_result* result, ptrdiff_t* lower,
                                        ptrdiff_t* upper);

/** 6 rows of 6. Returns 1; 0 where the pose has no covariance, and nothing is written. */
GMCR_C_API int gmcr_result_covariance(const gmcr_result* result, gmcr_pose_graph convention,
                                      double matrix[36]);

/** Of two clouds: the share of the source that has a point of the target within a voxel; else 0. */
GMCR_C_API double gmcr_result_fitness(const gmcr_result* result);

/** All that is known as one JSON object, docs/json.md. To be freed by gmcr_string_free; NULL after
 * an error, or where there was no memory. */
GMCR_C_API char* gmcr_result_to_json(const gmcr_result* result);

/** Of NULL nothing is freed. */
GMCR_C_API void gmcr_string_free(char* string);

#ifdef __cplusplus
}
#endif

#endif
