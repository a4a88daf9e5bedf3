/** Most corners a surfel has. */
export const MOST_CORNERS = 8;
/**
 * Numbers a surfel in `Surfels.data`: point, normal, tangent, bitangent (3 each), how many corners it has, then those in
 * terms of the latter two (2 each).
 */
export const STRIDE = 13 + 2 * MOST_CORNERS;
/** Where the number of a surfel's corners stands, the corners behind it. */
export const CORNERS = 12;
