// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Grammar/lms3dVRMLNodeTypes.h"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

namespace
{
using Type = lms3dVRMLNodeType;

struct Row
{
  Type::Roles Role;
  const char* Name;
  const char* Fields;
};

const Row Rows[] = {
  { Type::GROUP, "Anchor",
    "addChildren removeChildren children description parameter url bboxCenter bboxSize" },
  { Type::OTHER, "Appearance", "material texture textureTransform" },
  { Type::OTHER, "AudioClip",
    "description loop pitch startTime stopTime url duration_changed isActive" },
  { Type::OTHER, "Background",
    "set_bind groundAngle groundColor backUrl bottomUrl frontUrl leftUrl rightUrl topUrl skyAngle "
    "skyColor isBound" },
  { Type::GROUP, "Billboard",
    "addChildren removeChildren axisOfRotation children bboxCenter bboxSize" },
  { Type::BOX, "Box", "size" },
  { Type::GROUP, "Collision",
    "addChildren removeChildren children collide bboxCenter bboxSize proxy collideTime" },
  { Type::OTHER, "Color", "color" },
  { Type::OTHER, "ColorInterpolator", "set_fraction key keyValue value_changed" },
  { Type::CONE, "Cone", "bottomRadius height side bottom" },
  { Type::COORDINATE, "Coordinate", "point" },
  { Type::OTHER, "CoordinateInterpolator", "set_fraction key keyValue value_changed" },
  { Type::CYLINDER, "Cylinder", "bottom height radius side top" },
  { Type::OTHER, "CylinderSensor",
    "autoOffset diskAngle enabled maxAngle minAngle offset isActive rotation_changed "
    "trackPoint_changed" },
  { Type::OTHER, "DirectionalLight", "ambientIntensity color direction intensity on" },
  { Type::ELEVATION_GRID, "ElevationGrid",
    "set_height color normal texCoord height ccw colorPerVertex creaseAngle normalPerVertex solid "
    "xDimension xSpacing zDimension zSpacing" },
  { Type::EXTRUSION, "Extrusion",
    "set_crossSection set_orientation set_scale set_spine beginCap ccw convex creaseAngle "
    "crossSection endCap orientation scale solid spine" },
  { Type::OTHER, "Fog", "color fogType visibilityRange set_bind isBound" },
  { Type::OTHER, "FontStyle",
    "family horizontal justify language leftToRight size spacing style topToBottom" },
  { Type::GROUP, "Group", "addChildren removeChildren children bboxCenter bboxSize" },
  { Type::OTHER, "ImageTexture", "url repeatS repeatT" },
  { Type::INDEXED_FACE_SET, "IndexedFaceSet",
    "set_colorIndex set_coordIndex set_normalIndex set_texCoordIndex color coord normal texCoord "
    "ccw colorIndex colorPerVertex convex coordIndex creaseAngle normalIndex normalPerVertex solid "
    "texCoordIndex" },
  { Type::OTHER_GEOMETRY, "IndexedLineSet",
    "set_colorIndex set_coordIndex color coord colorIndex colorPerVertex coordIndex" },
  { Type::INLINE, "Inline", "url bboxCenter bboxSize" },
  { Type::LOD, "LOD", "level center range" },
  { Type::OTHER, "Material",
    "ambientIntensity diffuseColor emissiveColor shininess specularColor transparency" },
  { Type::OTHER, "MovieTexture",
    "loop speed startTime stopTime url repeatS repeatT duration_changed isActive" },
  { Type::OTHER, "NavigationInfo",
    "set_bind avatarSize headlight speed type visibilityLimit isBound" },
  { Type::OTHER, "Normal", "vector" },
  { Type::OTHER, "NormalInterpolator", "set_fraction key keyValue value_changed" },
  { Type::OTHER, "OrientationInterpolator", "set_fraction key keyValue value_changed" },
  { Type::OTHER, "PixelTexture", "image repeatS repeatT" },
  { Type::OTHER, "PlaneSensor",
    "autoOffset enabled maxPosition minPosition offset isActive trackPoint_changed "
    "translation_changed" },
  { Type::OTHER, "PointLight", "ambientIntensity attenuation color intensity location on radius" },
  { Type::OTHER_GEOMETRY, "PointSet", "color coord" },
  { Type::OTHER, "PositionInterpolator", "set_fraction key keyValue value_changed" },
  { Type::OTHER, "ProximitySensor",
    "center size enabled isActive position_changed orientation_changed enterTime exitTime" },
  { Type::OTHER, "ScalarInterpolator", "set_fraction key keyValue value_changed" },
  { Type::SCRIPT, "Script", "url directOutput mustEvaluate" },
  { Type::SHAPE, "Shape", "appearance geometry" },
  { Type::OTHER, "Sound",
    "direction intensity location maxBack maxFront minBack minFront priority source spatialize" },
  { Type::SPHERE, "Sphere", "radius" },
  { Type::OTHER, "SphereSensor",
    "autoOffset enabled offset isActive rotation_changed trackPoint_changed" },
  { Type::OTHER, "SpotLight",
    "ambientIntensity attenuation beamWidth color cutOffAngle direction intensity location on "
    "radius" },
  { Type::SWITCH, "Switch", "choice whichChoice" },
  { Type::OTHER_GEOMETRY, "Text", "string fontStyle length maxExtent" },
  { Type::OTHER, "TextureCoordinate", "point" },
  { Type::OTHER, "TextureTransform", "center rotation scale translation" },
  { Type::OTHER, "TimeSensor",
    "cycleInterval enabled loop startTime stopTime cycleTime fraction_changed isActive time" },
  { Type::OTHER, "TouchSensor",
    "enabled hitNormal_changed hitPoint_changed hitTexCoord_changed isActive isOver touchTime" },
  { Type::TRANSFORM, "Transform",
    "addChildren removeChildren center children rotation scale scaleOrientation translation "
    "bboxCenter bboxSize" },
  { Type::OTHER, "Viewpoint",
    "set_bind fieldOfView jump orientation position description bindTime isBound" },
  { Type::OTHER, "VisibilitySensor", "center enabled size enterTime exitTime isActive" },
  { Type::OTHER, "WorldInfo", "info title" },
};

std::vector<std::string_view> Split(std::string_view words)
{
  std::vector<std::string_view> result;
  while (!words.empty())
  {
    const std::size_t end = std::min(words.find(' '), words.size());
    result.push_back(words.substr(0, end));
    words.remove_prefix(std::min(end + 1, words.size()));
  }
  return result;
}

struct Table
{
  Table()
  {
    for (const Row& row : Rows)
    {
      const Type& type =
        this->Types.emplace(row.Name, Type{ row.Role, row.Name, Split(row.Fields) }).first->second;
      this->Fields.insert(type.Fields.begin(), type.Fields.end());
    }
  }

  std::unordered_map<std::string_view, Type> Types;
  std::unordered_set<std::string_view> Fields;
};

const Table& GetTable()
{
  static const Table table;
  return table;
}

std::string_view GetExposedField(std::string_view event)
{
  const std::string_view prefix = "set_";
  const std::string_view suffix = "_changed";
  if (event.substr(0, prefix.size()) == prefix)
  {
    return event.substr(prefix.size());
  }
  const bool hasSuffix =
    event.size() > suffix.size() && event.substr(event.size() - suffix.size()) == suffix;
  return hasSuffix ? event.substr(0, event.size() - suffix.size()) : event;
}
} // namespace

bool lms3dVRMLNodeType::HasField(std::string_view name) const
{
  const auto has = [this](std::string_view field)
  { return std::find(this->Fields.begin(), this->Fields.end(), field) != this->Fields.end(); };
  return has(name) || has(GetExposedField(name));
}

const lms3dVRMLNodeType* lms3dFindVRMLNodeType(std::string_view name)
{
  const auto found = GetTable().Types.find(name);
  return found == GetTable().Types.end() ? nullptr : &found->second;
}

std::string lms3dExplainUnknownNode(std::string_view name)
{
  return "VRML97 has no node " + std::string(name) + "; it is skipped";
}

bool lms3dIsVRMLColorField(std::string_view name)
{
  static const std::unordered_set<std::string_view> names = { "appearance", "material", "texture",
    "diffuseColor", "transparency", "color", "colorIndex", "colorPerVertex" };
  return names.count(name) > 0;
}

bool lms3dIsVRMLField(std::string_view name)
{
  return GetTable().Fields.count(name) > 0;
}
