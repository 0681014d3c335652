"""Kernels stand alone as machine code, and run as Python: each is called with numba switched off."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
TESTS = ROOT / "tests"
MADE = """
import sys
from support.kernels_called import all_kernels

for one in all_kernels():
    one.made()
print(len(all_kernels()), "numba" in sys.modules)
"""
IN_PYTHON = (
    "collision/test_contact_forces.py::test_a_face_that_rests_as_a_whole_and_a_ball_have_the_stated_stiffness",
    "collision/test_contact_forces.py::test_edges_and_corners_are_softer_as_the_manual_says",
    "simulation/test_contact_rows.py::test_a_contact_lasts_while_bodies_are_deeper_than_they_may_be",
    "simulation/test_ways_between_rows.py::test_a_plate_that_is_led_through_a_wall_at_full_speed_is_found[0.0005-0.0005-0]",
    "simulation/test_carrier_motion.py::test_frames_between_rows_are_within_the_stated_deviation[first_cell-0]",
    "controller/test_motion_clock.py::test_as_many_rows_are_asked_for_as_are_looked_at[700.0-0.4-30.0-30000.0]",
    "kinematics/bodies/test_blocks.py",
    "kinematics/test_external_axes.py",
    "kinematics/chain/test_forward.py::test_places_of_tools_are_those_of_their_poses",
    "kinematics/test_closed_arms.py::test_derivatives_of_the_axes_on_a_path_come_back_from_those_of_the_tool[five-bar]",
    "kinematics/test_closed_arms.py::test_a_path_is_followed_back_to_its_joints[five-bar]",
    "kinematics/test_closed_points.py::test_rows_on_a_line_are_on_it_and_have_their_derivatives[five-bar]",
    "kinematics/test_closed_points.py::test_the_search_in_all_coordinates_finds_the_pose_of_a_configuration[five-bar]",
    "kinematics/chain/test_loop_freedom.py::test_a_planar_linkage_has_the_freedom_of_its_axis[four-bar]",
    "kinematics/chain/test_closed_motion.py::test_a_chain_followed_along_a_path_is_where_it_is_followed_from_home[robot0]",
    "kinematics/test_free_intervals.py::test_the_ends_are_where_answers_end[narrow iiwa14]",
    "kinematics/test_free_intervals.py::test_without_limits_an_arm_moves_along_closed_curves_and_keeps_its_pose[iiwa14]",
    "kinematics/test_general_six_axis.py::test_it_has_the_answers_of_the_closed_forms[robot0]",
    "kinematics/test_points.py::test_a_guess_leads_to_the_answer_next_to_it",
    "kinematics/test_points.py::test_rows_beyond_the_reach_are_none_and_those_before_are_reached",
    "kinematics/test_points.py::test_rows_on_a_line_are_on_it_and_have_their_derivatives[planar 2R]",
    "kinematics/test_points.py::test_a_point_that_stands_is_reached_without_a_motion[planar 3R]",
    "kinematics/test_wrist_posture.py",
    "motion/compression/test_splines.py",
    "motion/compression/test_compression.py::test_two_moves_are_one_curve_as_near_to_their_point_as_its_blend",
    "motion/compression/test_random_chains.py::test_curves_deviate_as_stated_and_within_the_tolerances[30]",
    "motion/compression/test_random_chains.py::test_curves_deviate_as_stated_and_within_the_tolerances[57]",
    "motion/paths/test_spline.py::test_the_positions_are_those_of_the_natural_cubic_spline_over_chords",
    "motion/paths/test_line.py::test_the_distance_agrees_with_a_search",
    "motion/test_limit_kernels.py",
    "motion/test_limit_parts.py",
    "motion/test_place_kernel.py",
    "motion/test_evaluated.py",
    "motion/test_motion_time.py",
    "controller/test_part_times.py",
    "planning/blends/test_blend.py",
    "planning/blends/test_joined_ends.py::test_coordinates_are_the_integral_of_the_speeds_round_every_corner[iiwa14]",
    "planning/blends/test_joined_ends.py::test_coordinates_are_the_integral_of_the_speeds_round_every_corner[ur5e]",
    "planning/joint_limits/test_binding_kernel.py",
    "planning/joint_limits/test_joint_imposed_kernel.py",
    "planning/joint_limits/test_limit_grid_kernel.py",
    "planning/moves/test_joint_interpolator.py",
    "planning/trajectory/test_ticks_kernel.py",
    "planning/trajectory/test_timing_kernel.py",
    "planning/trajectory/test_trajectory_table.py",
    "simulation/test_attained.py::test_it_is_kept_in_the_frame_in_force_and_goes_where_it_was",
    "simulation/records/test_tally.py::test_tallies_of_two_parts_are_merged_into_that_of_the_whole",
    "simulation/records/test_tally.py::test_the_log_of_the_ideal_arm_has_a_row_at_every_so_many_ticks",
    "simulation/records/test_tally.py::test_the_greatest_of_a_span_is_found_beside_what_is_no_number",
    "simulation/records/test_tally.py::test_peaks_are_the_largest_magnitudes_of_columns",
    "workspace/volume/test_reachable.py::test_wherever_the_arm_goes_it_is_in_its_workspace[scara]",
)
"""Tests that call every kernel with arguments of its usual kind."""


def kernels_made() -> tuple[int, bool]:
    """Return how many kernels a new process has made or loaded, and whether it needed numba."""
    around = {**os.environ, "PYTHONPATH": str(TESTS)}
    result = subprocess.run(
        [sys.executable, "-c", MADE], env=around, capture_output=True, text=True, check=True
    )
    count, needed = result.stdout.split()
    return int(count), needed == "True"


def test_kernels_that_are_kept_are_loaded_without_numba() -> None:
    first, _ = kernels_made()  # compiles those that the cache folder does not hold yet
    again, needed = kernels_made()
    assert again == first > 30
    assert not needed


@pytest.mark.slow
def test_every_kernel_passes_tests_in_python_where_every_index_is_checked() -> None:
    """A new kernel needs a test in `IN_PYTHON`."""
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "-p", "support.kernels_called"]
    done = subprocess.run(
        [*command, *(f"tests/unit/{one}" for one in IN_PYTHON)],
        env={**os.environ, "NUMBA_DISABLE_JIT": "1", "PYTHONPATH": str(TESTS)},
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout[-5000:]
    assert "not called" not in done.stdout, done.stdout[-5000:]
