#pragma once

// Vulkan's handles by name, so that headers need not include Vulkan's: whoever calls it does.
using VkBuffer = struct VkBuffer_T*;
using VkBufferView = struct VkBufferView_T*;
using VkDescriptorSet = struct VkDescriptorSet_T*;
using VkDescriptorSetLayout = struct VkDescriptorSetLayout_T*;
using VkImageView = struct VkImageView_T*;
using VkInstance = struct VkInstance_T*;
using VkPhysicalDevice = struct VkPhysicalDevice_T*;
using VkSurfaceKHR = struct VkSurfaceKHR_T*;
