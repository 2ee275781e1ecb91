#pragma once

// Everything the library has, from the lowest level to the highest.
#include <airlight/constants.hpp>
#include <airlight/types.hpp>

#include <airlight/scene.hpp>

#include <airlight/gauss.hpp>
#include <airlight/node_map.hpp>
#include <airlight/nodes_for.hpp>
#include <airlight/numeric.hpp>

#include <airlight/arc_tangent.hpp>
#include <airlight/dawson.hpp>

#include <airlight/chapman.hpp>
#include <airlight/color.hpp>
#include <airlight/density.hpp>
#include <airlight/phase.hpp>
#include <airlight/ray_sphere.hpp>
#include <airlight/spectrum.hpp>

#include <airlight/atmosphere.hpp>
#include <airlight/atmospheres.hpp>
#include <airlight/viewpoint.hpp>

#include <airlight/view_path.hpp>

#include <airlight/column.hpp>
#include <airlight/occultation.hpp>
#include <airlight/planet_shadow.hpp>

#include <airlight/outward_column.hpp>
#include <airlight/ozone_ramps.hpp>
#include <airlight/sun_column.hpp>

#include <airlight/optical_depth.hpp>
#include <airlight/transmittance.hpp>

#include <airlight/hillaire_table.hpp>
#include <airlight/table_mapping.hpp>
#include <airlight/transmittance_table.hpp>

#include <airlight/ambient.hpp>
#include <airlight/single_scattering.hpp>

#include <airlight/scattering_mapping.hpp>
#include <airlight/sky_view_mapping.hpp>
#include <airlight/table_storage.hpp>

#include <airlight/gathering.hpp>
#include <airlight/ray_legs.hpp>

#include <airlight/light_shafts.hpp>

#include <airlight/diffuse_light.hpp>
#include <airlight/diffuse_table.hpp>
#include <airlight/gathered_light.hpp>
#include <airlight/multiple_scattering.hpp>
#include <airlight/sky_irradiance.hpp>

#include <airlight/scattering_of_table.hpp>
#include <airlight/scattering_orders.hpp>

#include <airlight/froxel_table.hpp>
#include <airlight/sky_view_table.hpp>

#include <airlight/compose.hpp>
#include <airlight/sun.hpp>

#include <airlight/aerial_perspective.hpp>
#include <airlight/sky.hpp>

#include <airlight/habitat.hpp>
#include <airlight/linear_light.hpp>

#include <airlight/habitat_indirect.hpp>
#include <airlight/habitat_irradiance.hpp>
#include <airlight/habitat_mapping.hpp>
#include <airlight/strip_phases.hpp>
#include <airlight/strip_scattering.hpp>

#include <airlight/habitat_scattering.hpp>
#include <airlight/habitats.hpp>
#include <airlight/point_light.hpp>
