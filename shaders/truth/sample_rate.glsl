// SPDX-License-Identifier: MIT
// Samples are spread evenly over time and pixel, so that the error of their mean falls as 1/n^k with k near `order`, 1,
// where independent ones would have 1/2. With n_i samples in tile i, whose error was e_i after the first P, the mean
// squared error of the picture is the mean of e_i^2 (P / n_i)^2k. For a number of samples that is smallest with n_i in
// proportion to e_i^q, q = 2 / (2k + 1) (k = 1/2: Neyman, "On the Two Different Aspects of the Representative Method",
// 1934). A smoother error m_i stands in for e_i: n_i = rate * m_i^q, and the rate is such that the error is that of
// `samples` everywhere.
// In:  tile_error (per tile: e_i, m_i).  Out: rate (x the rate, y the most that a tile gets).
void run(ivec2 pixel) {
  float k = params.order, q = 2.0 / (2.0 * k + 1.0);
  ivec2 size = textureSize(tile_error_tex, 0);
  float squares = 0.0, left = 0.0, largest = 0.0;
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      vec4 error = texelFetch(tile_error_tex, ivec2(x, y), 0);
      float square = error.x * error.x;
      squares += square;
      left += square > 0.0 ? square * pow(error.y, -2.0 * k * q) : 0.0;
      largest = max(largest, error.y);
    }
  }
  float rate = squares > 0.0 ? float(params.samples) * pow(left / squares, 1.0 / (2.0 * k)) : 0.0;
  float most = min(ceil(rate * pow(largest, q)), params.most * float(params.samples));
  imageStore(rate_img, pixel, vec4(rate, max(most, float(params.samples)), 0, 0));
}
