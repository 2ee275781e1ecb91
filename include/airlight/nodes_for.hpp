#pragma once

namespace airlight {

/// AIRLIGHT_CPU_ONLY, as all of this header: it chooses what a scene is compiled with, so it runs in the
/// compiler. Kinds of air that nodes_for tells apart.
enum class NodeAir {
    clear,  ///< no absorbing layer, or one of no absorption: CS562's Earth, Mars
    ozone,  ///< an absorbing layer as the Earth's
    thick,  ///< ten times the Earth's molecules
};

/// AIRLIGHT_CPU_ONLY. What of the measured errors is to stay within the tolerance.
enum class NodeError {
    p95,  ///< 95 of 100 views
    max,  ///< the worst view of thousands
};

/// AIRLIGHT_CPU_ONLY. The counts of nodes that have a rule of Gauss [1].
inline constexpr int node_counts[8] = {4, 5, 6, 8, 10, 12, 16, 24};

/// AIRLIGHT_CPU_ONLY. Measured error of the luminance, 95th percentile, by kind of view and count of
/// nodes [1]. Written by study/nodes_table.py from study/results/classes.csv.
inline constexpr double node_error_p95[15][8] = {
    {3.8e-03, 2.9e-03, 2.9e-04, 9.6e-06, 8.3e-06, 7.4e-06, 7.3e-06, 7.4e-06},  // no ozone, sun_mu >= 0.1
    {2.8e-02, 8.9e-03, 1.6e-03, 1.2e-04, 1.3e-05, 1.2e-05, 1.2e-05, 1.2e-05},  // no ozone, 0 <= sun_mu < 0.1
    {1.2e-01, 1.9e-02, 5.1e-03, 4.6e-04, 3.8e-05, 1.1e-05, 1.0e-05, 1.0e-05},  // no ozone, -0.1 <= sun_mu < 0
    {9.8e-02, 2.4e-02, 1.5e-02, 5.3e-04, 5.6e-05, 1.1e-05, 9.3e-06, 9.3e-06},  // no ozone, sun_mu < -0.1
    {3.7e-03, 2.8e-03, 6.7e-04, 2.5e-04, 1.2e-04, 1.1e-04, 1.1e-04, 9.7e-05},  // ozone, sun_mu >= 0.1
    {1.2e-02, 6.5e-03, 3.9e-03, 1.2e-03, 1.1e-03, 7.4e-04, 4.3e-04, 2.0e-04},  // ozone, 0 <= sun_mu < 0.1
    {9.6e-03, 8.1e-03, 6.0e-03, 1.9e-03, 1.9e-03, 8.6e-04, 7.4e-04, 2.8e-04},  // ozone, -0.1 <= sun_mu < 0
    {6.5e-03, 7.5e-03, 5.5e-03, 2.1e-03, 1.5e-03, 6.7e-04, 4.2e-04, 1.8e-04},  // ozone, sun_mu < -0.1
    {7.5e-03, 3.9e-03, 6.3e-04, 2.6e-04, 5.7e-06, 1.7e-06, 1.7e-06, 1.7e-06},  // thick, sun_mu >= 0.1
    {1.8e-01, 7.0e-02, 2.0e-02, 3.3e-03, 6.3e-04, 4.4e-05, 2.8e-06, 2.6e-06},  // thick, 0 <= sun_mu < 0.1
    {3.6e-01, 1.5e-01, 8.8e-02, 9.4e-03, 1.9e-03, 4.9e-04, 2.4e-05, 1.7e-06},  // thick, -0.1 <= sun_mu < 0
    {7.4e-02, 2.8e-02, 2.0e-02, 4.0e-03, 8.0e-04, 8.2e-05, 2.4e-06, 4.6e-07},  // thick, sun_mu < -0.1
    {9.2e-02, 1.8e-02, 4.3e-03, 3.5e-04, 2.6e-05, 7.4e-06, 4.7e-06, 4.7e-06},  // no ozone, from space
    {1.1e-02, 7.6e-03, 4.3e-03, 1.7e-03, 1.2e-03, 6.9e-04, 5.8e-04, 4.0e-04},  // ozone, from space
    {3.2e-01, 1.2e-01, 8.4e-02, 9.1e-03, 2.1e-03, 1.2e-03, 6.0e-05, 1.3e-06},  // thick, from space
};

/// AIRLIGHT_CPU_ONLY. The same, the largest.
inline constexpr double node_error_max[15][8] = {
    {3.6e-02, 5.8e-03, 1.4e-03, 5.1e-04, 9.0e-05, 1.8e-05, 1.1e-05, 1.1e-05},  // no ozone, sun_mu >= 0.1
    {7.0e-02, 2.0e-02, 5.2e-03, 6.9e-04, 8.5e-05, 3.1e-05, 3.1e-05, 3.1e-05},  // no ozone, 0 <= sun_mu < 0.1
    {1.5e-01, 4.7e-02, 2.4e-02, 1.9e-03, 1.8e-04, 4.4e-05, 2.4e-05, 2.4e-05},  // no ozone, -0.1 <= sun_mu < 0
    {1.5e-01, 5.2e-02, 2.9e-02, 2.4e-03, 2.2e-04, 2.3e-05, 1.4e-05, 1.4e-05},  // no ozone, sun_mu < -0.1
    {1.2e-02, 5.2e-03, 1.8e-03, 3.2e-03, 8.0e-04, 7.3e-04, 7.6e-04, 7.5e-04},  // ozone, sun_mu >= 0.1
    {3.3e-02, 1.7e-02, 8.3e-03, 5.0e-03, 3.3e-03, 2.7e-03, 1.2e-03, 5.5e-04},  // ozone, 0 <= sun_mu < 0.1
    {2.0e-02, 1.1e-02, 9.0e-03, 2.8e-03, 2.8e-03, 1.9e-03, 1.8e-03, 1.8e-03},  // ozone, -0.1 <= sun_mu < 0
    {1.4e-02, 1.1e-02, 9.1e-03, 3.2e-03, 3.1e-03, 1.0e-03, 5.7e-04, 3.5e-04},  // ozone, sun_mu < -0.1
    {2.2e-02, 9.1e-03, 4.0e-03, 3.6e-03, 1.6e-03, 3.7e-04, 3.3e-04, 1.1e-04},  // thick, sun_mu >= 0.1
    {2.1e-01, 8.3e-02, 3.2e-02, 5.2e-03, 1.3e-03, 1.3e-04, 7.8e-06, 3.1e-06},  // thick, 0 <= sun_mu < 0.1
    {4.1e-01, 1.9e-01, 1.6e-01, 2.0e-02, 3.6e-03, 9.8e-04, 2.9e-05, 2.5e-06},  // thick, -0.1 <= sun_mu < 0
    {2.8e-01, 7.5e-02, 7.9e-02, 6.2e-03, 1.4e-03, 2.6e-04, 3.5e-05, 1.4e-06},  // thick, sun_mu < -0.1
    {2.3e-01, 6.1e-02, 3.8e-02, 3.2e-03, 3.6e-04, 1.1e-04, 2.4e-05, 2.4e-05},  // no ozone, from space
    {2.8e-02, 2.1e-02, 1.3e-02, 6.1e-03, 4.0e-03, 1.9e-03, 1.6e-03, 1.6e-03},  // ozone, from space
    {5.1e-01, 2.1e-01, 1.6e-01, 2.7e-02, 6.4e-03, 4.8e-03, 2.6e-04, 2.0e-05},  // thick, from space
};

/// AIRLIGHT_CPU_ONLY. Measured error of single_scattering's luminance for a kind of view.
///
/// Units:    sun_mu [1], cosine of the sun's angle to the eye's vertical; result [1], relative, or relative
///           to 1e-4 of the zenith at noon where that is more.
/// Domain:   nodes one of node_counts; every sun_mu; in_space where the eye is above the air, then sun_mu
///           does not matter.
/// Accuracy: measured on 8000 views of five atmospheres, rounded up; other atmospheres differ.
/// Errors:   a count without a rule of Gauss gives 1.
/// Source:   docs/trade.md.
constexpr double node_error(int nodes, double sun_mu, NodeAir air = NodeAir::ozone, bool in_space = false,
                            NodeError error = NodeError::p95) {
    const int kind = static_cast<int>(air);
    const int sun = sun_mu >= 0.1 ? 0 : (sun_mu >= 0.0 ? 1 : (sun_mu >= -0.1 ? 2 : 3));
    const int row = in_space ? 12 + kind : 4 * kind + sun;
    for (int i = 0; i < 8; ++i) {
        if (node_counts[i] == nodes) {
            return error == NodeError::p95 ? node_error_p95[row][i] : node_error_max[row][i];
        }
    }
    return 1.0;
}

/// AIRLIGHT_CPU_ONLY. The fewest nodes whose measured error stays within a tolerance, for a kind of view.
///
///     struct Scene : airlight::DefaultScene {
///         static constexpr int nodes = airlight::nodes_for(0.002, -0.05);   // 0.2 %, sun 3 degrees down
///     };
///
/// A tool that knows the scene knows more: tools/advise measures the atmosphere and the views at hand.
///
/// Units:    tolerance [1], of the luminance; sun_mu [1] as in node_error.
/// Domain:   tolerance > 0. For a range of sun_mu take the largest result of its ends and of 0.
/// Accuracy: that of node_error.
/// Errors:   24 where even 24 nodes stay above the tolerance.
/// Source:   node_error.
constexpr int nodes_for(double tolerance, double sun_mu, NodeAir air = NodeAir::ozone, bool in_space = false,
                        NodeError error = NodeError::p95) {
    for (int i = 0; i < 8; ++i) {
        if (node_error(node_counts[i], sun_mu, air, in_space, error) <= tolerance) {
            return node_counts[i];
        }
    }
    return 24;
}

}  // namespace airlight
