// Small hand-made BVH files of the rigs that are met in the wild.
#pragma once

#include <string>
#include <string_view>

namespace posecoach::samples {

inline constexpr std::string_view kThreeJoints =
    "HIERARCHY\n"
    "ROOT base\n"
    "{\n"
    "  OFFSET 0 0 0\n"
    "  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n"
    "  JOINT middle\n"
    "  {\n"
    "    OFFSET 0 100 0\n"
    "    CHANNELS 3 Xrotation Yrotation Zrotation\n"
    "    End Site\n"
    "    {\n"
    "      OFFSET 0 70 0\n"
    "    }\n"
    "  }\n"
    "}\n"
    "MOTION\n"
    "Frames: 2\n"
    "Frame Time: 0.04\n"
    "1 2 3 0 0 0 0 0 0\n"
    "1 2 3 90 0 0 90 0 0\n";

// A body of 19 joints with the names in the order of `names`, in the unit that `size` says (1: metres), with
// two frames: standing, and turned by a quarter about the vertical.
struct RigNames {
  std::string_view hips, spine, chest, neck, head;
  std::string_view left_collar, left_arm, left_forearm, left_hand;
  std::string_view right_collar, right_arm, right_forearm, right_hand;
  std::string_view left_thigh, left_shin, left_foot, right_thigh, right_shin, right_foot;
};

inline constexpr RigNames kMixamo = {
    "mixamorig:Hips",       "mixamorig:Spine",         "mixamorig:Spine2",   "mixamorig:Neck",
    "mixamorig:Head",       "mixamorig:LeftShoulder",  "mixamorig:LeftArm",  "mixamorig:LeftForeArm",
    "mixamorig:LeftHand",   "mixamorig:RightShoulder", "mixamorig:RightArm", "mixamorig:RightForeArm",
    "mixamorig:RightHand",  "mixamorig:LeftUpLeg",     "mixamorig:LeftLeg",  "mixamorig:LeftFoot",
    "mixamorig:RightUpLeg", "mixamorig:RightLeg",      "mixamorig:RightFoot"};
inline constexpr RigNames kDaz = {"hip",      "abdomen", "chest",   "neck",   "head",     "lCollar", "lShldr",
                                  "lForeArm", "lHand",   "rCollar", "rShldr", "rForeArm", "rHand",   "lThigh",
                                  "lShin",    "lFoot",   "rThigh",  "rShin",  "rFoot"};
inline constexpr RigNames kBiovision = {
    "Hips",      "Waist",     "Chest",       "Neck",          "Head",       "LeftCollar", "LeftShoulder",
    "LeftElbow", "LeftWrist", "RightCollar", "RightShoulder", "RightElbow", "RightWrist", "LeftHip",
    "LeftKnee",  "LeftAnkle", "RightHip",    "RightKnee",     "RightAnkle"};
inline constexpr RigNames kBiped = {
    "Bip01 Pelvis",     "Bip01 Spine",      "Bip01 Spine1",    "Bip01 Neck",    "Bip01 Head",
    "Bip01 L Clavicle", "Bip01 L UpperArm", "Bip01 L Forearm", "Bip01 L Hand",  "Bip01 R Clavicle",
    "Bip01 R UpperArm", "Bip01 R Forearm",  "Bip01 R Hand",    "Bip01 L Thigh", "Bip01 L Calf",
    "Bip01 L Foot",     "Bip01 R Thigh",    "Bip01 R Calf",    "Bip01 R Foot"};
inline constexpr RigNames kUnreal = {"pelvis",     "spine_01",   "spine_03",   "neck_01", "head",
                                     "clavicle_l", "upperarm_l", "lowerarm_l", "hand_l",  "clavicle_r",
                                     "upperarm_r", "lowerarm_r", "hand_r",     "thigh_l", "calf_l",
                                     "foot_l",     "thigh_r",    "calf_r",     "foot_r"};
inline constexpr RigNames kSmpl = {"Pelvis",     "Spine1",     "Spine3",  "Neck",    "Head",
                                   "L_Collar",   "L_Shoulder", "L_Elbow", "L_Wrist", "R_Collar",
                                   "R_Shoulder", "R_Elbow",    "R_Wrist", "L_Hip",   "L_Knee",
                                   "L_Ankle",    "R_Hip",      "R_Knee",  "R_Ankle"};
inline constexpr RigNames kXsens = {"Hips",          "Chest",         "Chest4",        "Neck",
                                    "Head",          "LeftCollar",    "LeftUpperArm",  "LeftForeArm",
                                    "LeftHand",      "RightCollar",   "RightUpperArm", "RightForeArm",
                                    "RightHand",     "LeftUpperLeg",  "LeftLowerLeg",  "LeftFoot",
                                    "RightUpperLeg", "RightLowerLeg", "RightFoot"};
inline constexpr RigNames kAmc = {"root",      "lowerback", "thorax",  "lowerneck", "head",
                                  "lclavicle", "lhumerus",  "lradius", "lwrist",    "rclavicle",
                                  "rhumerus",  "rradius",   "rwrist",  "lfemur",    "ltibia",
                                  "lfoot",     "rfemur",    "rtibia",  "rfoot"};
inline constexpr RigNames kOwn = {"pelvis",      "spine",          "chest",          "neck",
                                  "head",        "left_clavicle",  "left_shoulder",  "left_elbow",
                                  "left_wrist",  "right_clavicle", "right_shoulder", "right_elbow",
                                  "right_wrist", "left_hip",       "left_knee",      "left_ankle",
                                  "right_hip",   "right_knee",     "right_ankle"};

enum class UpAxis { Y, Z };

std::string body_bvh(const RigNames& names, double units_per_metre, UpAxis up = UpAxis::Y);

}  // namespace posecoach::samples
