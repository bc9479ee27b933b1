// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Meshes/lms3dVRMLColors.h"

#include <algorithm>
#include <cmath>
#include <string>

lms3dColor lms3dMakeColor(const std::array<double, 3>& color)
{
  lms3dColor bytes;
  std::transform(color.begin(), color.end(), bytes.begin(),
    [](double share)
    {
      const double finite = std::isnan(share) ? 0.0 : std::clamp(share, 0.0, 1.0);
      return static_cast<std::uint8_t>(std::lround(255.0 * finite));
    });
  return bytes;
}

lms3dVRMLColors::lms3dVRMLColors(
  lms3dVRMLEvaluator& evaluator, const lms3dVRMLNodeInContext& geometry)
  : Evaluator(evaluator)
  , Geometry(geometry)
  , PerVertex(evaluator.GetBool(geometry, "colorPerVertex", true))
{
  const lms3dVRMLNodeInContext color = evaluator.GetNode(geometry, "color", "Color");
  if (color.Node)
  {
    this->Values = evaluator.GetReals(color, "color", 3);
  }
}

void lms3dVRMLColors::ReportMissing()
{
  if (!this->HasReportedMissing)
  {
    this->HasReportedMissing = true;
    this->Evaluator.Warn(this->Geometry,
      std::string(this->Geometry.Node->TypeName) + " has fewer colours than it uses");
  }
}

// A missing colour becomes the default diffuse colour of a Material.
std::array<double, 3> lms3dVRMLColors::GetReal(std::int64_t color)
{
  const std::int64_t count = static_cast<std::int64_t>(this->Values->size() / 3);
  if (color < 0 || color >= count)
  {
    this->ReportMissing();
    return { 0.8, 0.8, 0.8 };
  }
  const double* values = this->Values->data() + 3 * color;
  return { values[0], values[1], values[2] };
}

lms3dColor lms3dVRMLColors::Get(std::int64_t color)
{
  return lms3dMakeColor(this->GetReal(color));
}

lms3dColor lms3dVRMLColors::GetMean(const std::array<std::int64_t, 3>& colors)
{
  std::array<double, 3> mean = { 0, 0, 0 };
  for (std::int64_t color : colors)
  {
    const std::array<double, 3> corner = this->GetReal(color);
    for (int i = 0; i < 3; ++i)
    {
      mean[i] += corner[i] / 3.0;
    }
  }
  return lms3dMakeColor(mean);
}
