/* The paper's seven costs as printed, for a population of boxes: the measure of our kernels.

   The same formulas, the same loops and the same early outs as scenewright.terms, written the way
   a C programmer would, for one thread. Compiled by benchmarks/home_kernel.py. */

#include <math.h>

#define MIN(a, b) ((a) < (b) ? (a) : (b))
#define MAX(a, b) ((a) > (b) ? (a) : (b))
#define CLAMP(v, low, high) MIN(MAX(v, low), high)

typedef struct {
    double x, y, c, s, w, d, radius, heading;
} Frame;

typedef struct {
    const double *edges, *walls, *zones, *back, *role, *targets, *weights;
    const long long *pairs;
    double area, normal;
    long long edge_count, wall_count, zone_count, item_count, pair_count;
} Room;

static const double PI = 3.14159265358979323846;

static Frame make_frame(const double *box) {
    const double w = 0.5 * box[3], d = 0.5 * box[4];
    const Frame frame = {box[0], box[1], cos(box[2]), sin(box[2]), w, d, sqrt(w * w + d * d), box[2]};
    return frame;
}

static inline double wrap(double angle) {
    return angle - 2.0 * PI * floor((angle + PI) / (2.0 * PI));
}

static inline double area_under(double u0, double v0, double u1, double v1, double w, double d) {
    const double low = MIN(u0, u1), high = MAX(u0, u1), h = 2.0 * d;
    if (high <= -w || low >= w || (v0 <= -d && v1 <= -d)) return 0.0;
    const double a = CLAMP(u0, -w, w), b = CLAMP(u1, -w, w);
    if (v0 >= d && v1 >= d) return (a - b) * h;
    if (high <= low) return 0.0;
    const double slope = (v1 - v0) / (u1 - u0);
    const int near_a = fabs(a - u0) <= fabs(a - u1), near_b = fabs(b - u1) <= fabs(b - u0);
    const double s0 = (near_a ? v0 + (a - u0) * slope : v1 + (a - u1) * slope) + d;
    const double s1 = (near_b ? v1 + (b - u1) * slope : v0 + (b - u0) * slope) + d;
    const double c0 = CLAMP(s0, 0.0, h), c1 = CLAMP(s1, 0.0, h), middle = 0.5 * (c0 + c1);
    const double share = s1 != s0 ? (c1 - c0) / (s1 - s0) : 0.0;
    return (a - b) * (middle + share * (0.5 * (s0 + s1) - middle));
}

static double area_in_polygon(const Frame *f, const double *edges, long long count) {
    double total = 0.0;
    for (long long e = 0; e < count; e++) {
        const double *edge = edges + 4 * e;
        const double x0 = edge[0] - f->x, y0 = edge[1] - f->y;
        const double x1 = edge[2] - f->x, y1 = edge[3] - f->y;
        total += area_under(x0 * f->s - y0 * f->c, x0 * f->c + y0 * f->s,
                            x1 * f->s - y1 * f->c, x1 * f->c + y1 * f->s, f->w, f->d);
    }
    return CLAMP(total, 0.0, 4.0 * f->w * f->d);
}

static double common_area(const Frame *a, const Frame *b) {
    const double dx = b->x - a->x, dy = b->y - a->y, reach = a->radius + b->radius;
    if (dx * dx + dy * dy >= reach * reach) return 0.0;
    const double u = dx * a->s - dy * a->c, v = dx * a->c + dy * a->s;
    const double c = b->c * a->c + b->s * a->s, s = b->s * a->c - b->c * a->s;
    const double ru = c * b->w, rv = s * b->w, fu = -s * b->d, fv = c * b->d;
    const double u0 = u + ru - fu, v0 = v + rv - fv, u1 = u + ru + fu, v1 = v + rv + fv;
    const double u2 = u - ru + fu, v2 = v - rv + fv, u3 = u - ru - fu, v3 = v - rv - fv;
    const double w = a->w, d = a->d;
    const double total = area_under(u0, v0, u1, v1, w, d) + area_under(u1, v1, u2, v2, w, d) +
                         area_under(u2, v2, u3, v3, w, d) + area_under(u3, v3, u0, v0, w, d);
    return CLAMP(total, 0.0, 4.0 * MIN(w * d, b->w * b->d));
}

static double nearest(double x, double y, const double *walls, long long count) {
    double least = INFINITY;
    for (long long k = 0; k < count; k++) {
        const double *wall = walls + 4 * k;
        const double ex = wall[2] - wall[0], ey = wall[3] - wall[1];
        const double px = x - wall[0], py = y - wall[1], length = ex * ex + ey * ey;
        const double t = length > 0.0 ? CLAMP((px * ex + py * ey) / length, 0.0, 1.0) : 0.0;
        const double dx = px - t * ex, dy = py - t * ey;
        least = MIN(least, dx * dx + dy * dy);
    }
    return sqrt(least);
}

/* Weights: boundary, overlap, keep free, main wall, against wall, pairs, size. */
static double energy(const Room *room, const double *boxes, Frame *frames) {
    const double *w = room->weights;
    double shared = 0.0, own = 0.0, area = 0.0, turn = 0.0;
    for (long long i = 0; i < room->item_count; i++) frames[i] = make_frame(boxes + 5 * i);
    for (long long i = 0; i < room->item_count; i++) {
        const Frame *f = frames + i;
        const double size = 4.0 * f->w * f->d;
        const double outside = size - area_in_polygon(f, room->edges, room->edge_count);
        shared += w[0] * MAX(outside, 0.0);
        for (long long k = 0; k < room->zone_count; k++) {
            const double *z = room->zones + 8 * k;
            const Frame zone = {z[0], z[1], z[2], z[3], z[4], z[5], z[6], z[7]};
            shared += w[2] * common_area(f, &zone);
        }
        if (room->role[i] != 0.0) {
            double turned = f->heading - room->normal;
            turned -= 2.0 * PI * floor(turned / (2.0 * PI));
            turn += room->role[i] * (turned - (room->role[i] + 1.0) * 0.5 * PI);
        }
        if (room->back[i] != 0.0) {
            const double x = f->x - f->c * f->d, y = f->y - f->s * f->d;
            const double far = nearest(x, y, room->walls, room->wall_count);
            own += far <= 0.1 ? 0.0 : w[4] * room->back[i] * (1.0 - (0.1 / far) * (0.1 / far));
        }
        area += size;
        for (long long j = 0; j < i; j++) shared += w[1] * common_area(f, frames + j);
    }
    for (long long r = 0; r < room->pair_count; r++) {
        const Frame *a = frames + room->pairs[2 * r], *b = frames + room->pairs[2 * r + 1];
        const double dx = b->x - a->x, dy = b->y - a->y, *target = room->targets + 4 * r;
        double off = 0.0;
        if (!isnan(target[0])) off += fabs(sqrt(dx * dx + dy * dy) - target[0]);
        if (!isnan(target[1]))
            off += fabs(fabs(wrap(b->heading - a->heading)) - fabs(wrap(target[1])));
        own += w[5] * off * target[3];
    }
    double size = 0.0;
    const double share = area / room->area;
    if (share < 0.40) size = 1.0 - (share / 0.40) * (share / 0.40);
    if (share > 0.55) size = 1.0 - (0.55 / share) * (0.55 / share);
    return own + w[3] * fabs(turn) + (area > 0.0 ? shared / area : 0.0) + w[6] * size;
}

void energies(const Room *room, const double *population, long long count, void *frames,
              double *found) {
    for (long long k = 0; k < count; k++)
        found[k] = energy(room, population + 5 * room->item_count * k, frames);
}
