/* The march of dcfp with simplified heating, written by hand in C: what the compiled kernels are measured against.
 *
 * The same operations on the same arrays, in N, mm, s, degC; all mechanics is per unit mass of the structure.
 * A sum over modes may be taken in any order, as in the kernels; nothing else may.
 */

#include <math.h>
#include <stdbool.h>
#include <stddef.h>

#ifndef MODES /* the benchmark gives the kernels' own number */
#define MODES 16
#endif
#define TRACE 1e-100
#define FINEST_LEVEL 10
#define ODD_LENGTH (FINEST_LEVEL + 1)
#define LARGEST_ANGLE 0.55
#define CLOSE 1e-10
#define MOST_STEPS_PER_SAMPLE 20000

/* length of a step over the sample interval, by level */
static const double halves[FINEST_LEVEL + 1] = {
    0x1p0, 0x1p-1, 0x1p-2, 0x1p-3, 0x1p-4, 0x1p-5, 0x1p-6, 0x1p-7, 0x1p-8, 0x1p-9, 0x1p-10,
};

/* ----- what Python hands over; the order is that of the named tuples there ----- */

struct law {
    double reference, speed_drop, speed_rate, heat_scale, heat_rate, heat_floor;
};

struct structure {
    double restoring, elastic, gravity, pressure, reach;
    long plates;
    double first_share, second_share, first_speed, second_speed;
};

struct steel {
    double ambient, half_contact, instant;
    double rates[MODES], weights[MODES];
};

/* what the march adds up and leaves behind */
struct outcome {
    double input, hysteretic, turning;
    double peak_displacement, peak_change, peak_velocity, peak_force, peak_temperature, least_friction;
    double steps;
};

/* columns of the histories */
enum { DISPLACEMENT, VELOCITY, ELONGATION, FRICTION, SIDE, INPUT, HYSTERETIC, TEMPERATURE };

enum status { DONE, AT_REST, OUT_OF_CELLS, NO_PROGRESS };

/* ----- what stays here ----- */

struct motion {
    double displacement, velocity, elongation;
    int side;
};

struct push {
    double now, rate;
};

struct advance {
    struct motion motion;
    double length, input, hysteretic, friction, turning;
};

struct swing {
    double displacement, velocity, area, moment;
};

struct prepared {
    double length; /* negative if the step can only cool */
    double opening_sum, closing_sum;
    double fade[MODES], opening[MODES], closing[MODES];
};

struct heat {
    const struct steel *steel;
    double present[2], expected[2], between[2];
    double ratio[2]; /* of a plate's coefficient to that of the bearing */
    double modes[2][MODES];
    struct prepared steps[ODD_LENGTH + 1];
};

/* fmax and fmin take pains over what is not a number; these are one instruction */
static inline double larger(double a, double b)
{
    return a > b ? a : b;
}

static inline double smaller(double a, double b)
{
    return a < b ? a : b;
}

/* ----- oscillator ----- */

static inline struct swing swing(double stiffness, double h, double v0, double acceleration, double push_rate,
                                 double push_curvature)
{
    const double z = stiffness * h * h;
    const double phi5 =
        1.0 / 120.0
        * (1.0 - z * (1.0 / 42.0) * (1.0 - z * (1.0 / 72.0) * (1.0 - z * (1.0 / 110.0) * (1.0 - z * (1.0 / 156.0)))));
    const double phi6 =
        1.0 / 720.0
        * (1.0 - z * (1.0 / 56.0) * (1.0 - z * (1.0 / 90.0) * (1.0 - z * (1.0 / 132.0) * (1.0 - z * (1.0 / 182.0)))));
    const double phi4 = 1.0 / 24.0 - z * phi6;
    const double phi3 = 1.0 / 6.0 - z * phi5;
    const double phi2 = 0.5 - z * phi4;
    const double phi1 = 1.0 - z * phi3;
    const double phi0 = 1.0 - z * phi2;
    const double a0 = acceleration * h;
    const double p1 = push_rate * (h * h);
    const double p2 = push_curvature * (2.0 * h * h * h);
    return (struct swing){
        h * (v0 * phi1 + a0 * phi2 + p1 * phi3 + p2 * phi4),
        v0 * phi0 + a0 * phi1 + p1 * phi2 + p2 * phi3,
        h * h * (v0 * phi2 + a0 * phi3 + p1 * phi4 + p2 * phi5),
        h * h * h * (v0 * phi3 + a0 * phi4 + p1 * phi5 + p2 * phi6),
    };
}

static inline double work(double constant, double rate, double curvature, double h, struct swing swung)
{
    const double dy = swung.displacement;
    const double first = h * dy - swung.area;
    const double second = h * h * dy - 2.0 * h * swung.area + 2.0 * swung.moment;
    return constant * dy + rate * first + curvature * second;
}

/* ----- friction ----- */

static inline double coefficient(const struct law *law, double speed, double temperature)
{
    const double speed_factor = 1.0 - law->speed_drop * exp(-law->speed_rate * speed);
    const double heat_factor = law->heat_scale * exp(-law->heat_rate * temperature) + law->heat_floor;
    return law->reference * speed_factor * heat_factor;
}

static inline double mean_coefficient(const struct law *law, const struct structure *structure, double speed,
                                      const double *temperature)
{
    const double one = coefficient(law, structure->first_speed * speed, temperature[0]);
    if (structure->plates == 1)
        return one;
    const double other = coefficient(law, structure->second_speed * speed, temperature[1]);
    return structure->first_share * one + structure->second_share * other;
}

static inline void note_ratios(const struct law *law, const struct structure *structure, double speed,
                               const double *temperature, double *ratio)
{
    if (structure->plates == 1)
        return;
    const double one = coefficient(law, structure->first_speed * speed, temperature[0]);
    const double other = coefficient(law, structure->second_speed * speed, temperature[1]);
    const double mean = structure->first_share * one + structure->second_share * other;
    ratio[0] = one / mean;
    ratio[1] = other / mean;
}

static inline double share(const struct structure *structure, int plate)
{
    return plate == 0 ? structure->first_share : structure->second_share;
}

/* ----- memory of past heat ----- */

static void fill_fade(const struct steel *steel, double length, double *restrict fade)
{
    for (int j = 0; j < 4; j++)
        fade[j] = exp(-steel->rates[j] * length);
    for (int j = 4; j < MODES; j++) {
        double f = fade[j - 2];
        f *= f;
        f *= f;
        f *= f;
        fade[j] = f;
    }
}

static void fill_weights(const struct steel *steel, double length, struct prepared *restrict step)
{
    for (int j = 0; j < MODES; j++) {
        const double x = steel->rates[j] * length;
        const double e = step->fade[j];
        const double scale = steel->weights[j] * length;
        const double near_opening = 0.5 - x * (1.0 / 3.0 - x * (0.125 - x * (1.0 / 30.0 - x * (1.0 / 144.0))));
        const double near_closing = 0.5 - x * (1.0 / 6.0 - x * (1.0 / 24.0 - x * (1.0 / 120.0 - x * (1.0 / 720.0))));
        const double over = 1.0 / (x * x);
        const double far_opening = (1.0 - e - x * e) * over;
        const double far_closing = (x - 1.0 + e) * over;
        step->opening[j] = scale * (x < 0.05 ? near_opening : far_opening);
        step->closing[j] = scale * (x < 0.05 ? near_closing : far_closing);
    }
    double opening = 0.0, closing = 0.0;
#pragma omp simd reduction(+ : opening, closing)
    for (int j = 0; j < MODES; j++) {
        opening += step->opening[j];
        closing += step->closing[j];
    }
    step->opening_sum = opening;
    step->closing_sum = closing;
}

static inline double faded_total(const double *restrict fade, const double *restrict modes)
{
    double sum = 0.0;
#pragma omp simd reduction(+ : sum)
    for (int j = 0; j < MODES; j++)
        sum += fade[j] * modes[j];
    return sum;
}

static inline double let_fade(const double *restrict fade, double *restrict modes)
{
    double sum = 0.0;
#pragma omp simd reduction(+ : sum)
    for (int j = 0; j < MODES; j++) {
        modes[j] = fade[j] * modes[j] + TRACE;
        sum += modes[j];
    }
    return sum;
}

static inline double feed(const struct prepared *restrict step, double *restrict modes, double flux_start,
                          double flux_end)
{
    double sum = 0.0;
#pragma omp simd reduction(+ : sum)
    for (int j = 0; j < MODES; j++) {
        modes[j] = step->fade[j] * modes[j] + step->opening[j] * flux_start + step->closing[j] * flux_end;
        sum += modes[j];
    }
    return sum;
}

/* ----- heating ----- */

static inline void prepare_cooling(struct heat *heat, int place, double length)
{
    struct prepared *step = &heat->steps[place];
    if (fabs(step->length) != length) {
        fill_fade(heat->steel, length, step->fade);
        step->length = -length;
    }
}

static inline void prepare(struct heat *heat, int place, double length)
{
    struct prepared *step = &heat->steps[place];
    if (step->length == length)
        return;
    if (step->length != -length)
        fill_fade(heat->steel, length, step->fade);
    fill_weights(heat->steel, length, step);
    step->length = length;
}

static inline bool feels_flux(const struct heat *heat, double portion, double displacement)
{
    return fabs(portion * displacement) <= heat->steel->half_contact;
}

static inline void expect(struct heat *heat, const struct structure *structure, int place, double displacement,
                          double flux_start, double flux_end)
{
    const struct prepared *step = &heat->steps[place];
    for (int i = 0; i < structure->plates; i++) {
        const double portion = share(structure, i);
        double rise = faded_total(step->fade, heat->modes[i]);
        if (feels_flux(heat, portion, displacement))
            rise += portion * heat->ratio[i]
                    * (step->opening_sum * flux_start + (step->closing_sum + heat->steel->instant) * flux_end);
        heat->expected[i] = heat->steel->ambient + rise;
    }
}

static inline void expect_cooling(struct heat *heat, const struct structure *structure, int place)
{
    for (int i = 0; i < structure->plates; i++)
        heat->expected[i] = heat->steel->ambient + faded_total(heat->steps[place].fade, heat->modes[i]);
}

static inline void mix(struct heat *heat, const struct structure *structure, double part, double *mixed)
{
    for (int i = 0; i < structure->plates; i++)
        mixed[i] = heat->present[i] + part * (heat->expected[i] - heat->present[i]);
}

static inline void heat_up(struct heat *heat, const struct structure *structure, int place, double middle,
                           double flux_start, double flux_end, double flux_now)
{
    for (int i = 0; i < structure->plates; i++) {
        const double portion = share(structure, i);
        const double felt = feels_flux(heat, portion, middle) ? portion * heat->ratio[i] : 0.0;
        double rise = feed(&heat->steps[place], heat->modes[i], felt * flux_start, felt * flux_end);
        rise += heat->steel->instant * felt * flux_now;
        heat->present[i] = heat->steel->ambient + rise;
    }
}

static inline void cool_down(struct heat *heat, const struct structure *structure, int place)
{
    for (int i = 0; i < structure->plates; i++)
        heat->present[i] = heat->steel->ambient + let_fade(heat->steps[place].fade, heat->modes[i]);
}

/* ----- sticking ----- */

static double turn_of(double stiffness, double length, double last, double velocity, double acceleration,
                      double push_rate)
{
    double low = 0.0, high = length;
    const double going = velocity != 0.0 ? velocity : acceleration;
    double t = length * velocity / (velocity - last);
    if (t < 0.01 * length)
        t = 0.5 * length;
    for (int round = 0; round < 30; round++) {
        const struct swing swung = swing(stiffness, t, velocity, acceleration, -push_rate, 0.0);
        if (swung.velocity * going > 0.0)
            low = t;
        else
            high = t;
        const double now = acceleration - push_rate * t - stiffness * swung.displacement;
        double better = now != 0.0 ? t - swung.velocity / now : 0.5 * (low + high);
        if (!(low <= better && better <= high))
            better = 0.5 * (low + high);
        const bool close = fabs(better - t) < 1e-8 * length;
        t = better;
        if (close)
            break;
    }
    return t;
}

/* The sticking step within which a slip is looked for. */
struct search {
    const struct law *law;
    const struct structure *structure;
    const struct motion *motion;
    double stiffness, start, push_rate, length, side;
};

static double excess(const struct search *search, struct heat *heat, double time, double allowed)
{
    mix(heat, search->structure, time / search->length, heat->between);
    const struct swing swung =
        swing(search->stiffness, time, search->motion->velocity, search->start, -search->push_rate, 0.0);
    const double friction = mean_coefficient(search->law, search->structure, fabs(swung.velocity), heat->between);
    return search->side * (search->motion->elongation + swung.displacement) - friction * search->structure->reach
           - allowed;
}

static double slip_time(struct search search, struct heat *heat, double low, double high)
{
    const struct swing last =
        swing(search.stiffness, high, search.motion->velocity, search.start, -search.push_rate, 0.0);
    search.side = search.motion->elongation + last.displacement > 0.0 ? 1.0 : -1.0;
    /* a sticking phase begins on the surface, as closely as the temperature was expected */
    const double first = excess(&search, heat, low, 0.0);
    const double outside = larger(first, 0.0);
    double beyond = excess(&search, heat, high, outside);
    if (beyond <= 0.0)
        return INFINITY;
    double below = smaller(first - outside, -CLOSE);
    int kept = 0;
    for (int round = 0; round < 60; round++) {
        const double middle = high - beyond * (high - low) / (beyond - below);
        const double there = excess(&search, heat, middle, outside);
        if (fabs(there) < CLOSE)
            return middle;
        if (there > 0.0) {
            high = middle;
            beyond = there;
            if (kept == -1)
                below *= 0.5;
            kept = -1;
        } else {
            low = middle;
            below = there;
            if (kept == 1)
                beyond *= 0.5;
            kept = 1;
        }
    }
    return high;
}

static struct advance stick_step(const struct law *law, const struct structure *structure, struct heat *heat,
                                 struct motion motion, struct push push, double room, double interval)
{
    const double stiffness = structure->restoring + structure->elastic;
    const double y = motion.displacement, v = motion.velocity;
    double x = motion.elongation;
    const double start = -push.now - structure->restoring * y - structure->elastic * x;
    double length = room;
    if (room * room * stiffness > LARGEST_ANGLE * LARGEST_ANGLE)
        length = room / ceil(room * sqrt(stiffness) / LARGEST_ANGLE);
    struct swing swung = swing(stiffness, length, v, start, -push.rate, 0.0);
    double friction = mean_coefficient(law, structure, fabs(swung.velocity), heat->present);
    bool slips = fabs(x + swung.displacement) > friction * structure->reach;
    double low = 0.0, high = length, turning = NAN;
    const double going = v != 0.0 ? v : start;
    if (going * swung.velocity < 0.0) {
        const double turn = turn_of(stiffness, length, swung.velocity, v, start, push.rate);
        const double turned = swing(stiffness, turn, v, start, -push.rate, 0.0).displacement;
        turning = y + turned;
        const double slow = mean_coefficient(law, structure, 0.0, heat->present);
        if (fabs(x + turned) > slow * structure->reach) {
            slips = true;
            high = turn;
        } else {
            low = turn;
        }
    }
    if (slips) {
        const int place = length == interval ? 0 : ODD_LENGTH;
        prepare_cooling(heat, place, length);
        expect_cooling(heat, structure, place);
        const struct search search = {law, structure, &motion, stiffness, start, push.rate, length, 0.0};
        const double slip = slip_time(search, heat, low, high);
        const bool cut = high < length;
        slips = slip <= high;
        length = smaller(slip, high);
        swung = swing(stiffness, length, v, start, -push.rate, 0.0);
        friction = fabs(x + swung.displacement) / structure->reach;
        if (cut && (!slips || going * swung.velocity <= 0.0)) {
            slips = false;
            swung.velocity = 0.0;
        } else if (low == 0.0 && length < high) {
            turning = NAN;
        }
    }
    if (length > 0.0) {
        const int place = length == interval ? 0 : ODD_LENGTH;
        prepare_cooling(heat, place, length);
        cool_down(heat, structure, place);
    }
    x += swung.displacement;
    const int side = slips ? (x > 0.0 ? 1 : -1) : 0;
    return (struct advance){
        {y + swung.displacement, swung.velocity, x, side},
        length,
        -work(push.now, push.rate, 0.0, length, swung),
        0.0,
        friction,
        turning,
    };
}

/* ----- sliding ----- */

static inline double next_length(double length, double room)
{
    if (room <= length * (1.0 + 1e-9))
        return fabs(room - length) < 1e-9 * length ? length : room;
    if (room < 2.0 * length)
        return fabs(room - 2.0 * length) > 1e-9 * length ? 0.5 * room : length;
    return length;
}

static inline double turning_time(double velocity, double acceleration, double jerk, double length)
{
    const double sign = velocity > 0.0 ? 1.0 : -1.0;
    const double v = sign * velocity, a = sign * acceleration, j = sign * jerk;
    if (v <= 0.0)
        return INFINITY;
    const bool ends_behind = v + length * (a + 0.5 * length * j) < 0.0;
    const bool dips = a < 0.0 && a + j * length > 0.0;
    if (!(ends_behind || dips))
        return INFINITY;
    const double under_root = a * a - 2.0 * j * v;
    if (under_root < 0.0)
        return INFINITY;
    const double denominator = -a + sqrt(under_root);
    return denominator > 0.0 ? 2.0 * v / denominator : INFINITY;
}

static bool polish_turn(double stiffness, double *restrict length, double furthest, double velocity,
                        double acceleration, double push_rate, double push_curve)
{
    double h = *length, low = 0.0, high = h;
    if (swing(stiffness, h, velocity, acceleration, push_rate, push_curve).velocity * velocity > 0.0) {
        const struct swing last = swing(stiffness, furthest, velocity, acceleration, push_rate, push_curve);
        if (last.velocity * velocity > 0.0)
            return false;
        low = h;
        high = furthest;
    }
    for (int round = 0; round < 50; round++) {
        const struct swing swung = swing(stiffness, h, velocity, acceleration, push_rate, push_curve);
        if (swung.velocity * velocity > 0.0)
            low = h;
        else
            high = h;
        const double now = acceleration + h * (push_rate + h * push_curve) - stiffness * swung.displacement;
        double better = now != 0.0 ? h - swung.velocity / now : 0.5 * (low + high);
        if (!(low <= better && better <= high))
            better = 0.5 * (low + high);
        const bool close = fabs(better - h) < 1e-8 * *length;
        h = better;
        if (close)
            break;
    }
    *length = h;
    return true;
}

static inline double leaving_time(const struct heat *heat, const struct structure *structure, double displacement,
                                  double travel, double velocity, double acceleration, double jerk, double length)
{
    const double half_contact = heat->steel->half_contact;
    double earliest = INFINITY;
    const double end = displacement + travel;
    for (int i = 0; i < structure->plates; i++) {
        const double portion = share(structure, i);
        const bool inside = portion * fabs(displacement) <= half_contact;
        if (inside == (portion * fabs(end) <= half_contact))
            continue;
        const double outer = fabs(displacement) > fabs(end) ? displacement : end;
        const double target = copysign(half_contact / portion, outer);
        double t = length * (target - displacement) / travel;
        for (int round = 0; round < 6; round++) {
            const double away = displacement - target + t * (velocity + t * (0.5 * acceleration + t * jerk / 6.0));
            const double rate = velocity + t * (acceleration + 0.5 * t * jerk);
            if (rate == 0.0)
                break;
            t = smaller(larger(t - away / rate, 0.0), length);
        }
        if (t > 1e-9 * length)
            earliest = smaller(earliest, t);
    }
    return earliest;
}

static struct advance slide_step(const struct law *law, const struct structure *structure, struct heat *heat,
                                 bool fresh, struct motion motion, struct push push, double room, double interval,
                                 int *restrict level, int coarsest, double tolerance)
{
    const double friction = fabs(motion.elongation) / structure->reach;
    const double y = motion.displacement, v = motion.velocity, side = motion.side;
    const double start = -push.now - structure->restoring * y - side * structure->gravity * friction;
    const double jerk = -push.rate - structure->restoring * v;
    const double flux = structure->pressure * friction;
    const double opening = flux * fabs(v);
    double regular, length, last, bend;
    bool turns;
    int place;

    for (;;) {
        regular = interval * halves[*level];
        length = next_length(regular, room);
        turns = false;
        const double turn = turning_time(v, start, jerk, length);
        if (turn < 1e-12 * regular) /* it moves no more */
            return (struct advance){{y, 0.0, motion.elongation, 0}, 0.0, 0.0, 0.0, friction, y};
        if (turn < length) {
            length = turn;
            turns = true;
        }
        double travel = length * (v + 0.5 * length * start);
        const double leave = leaving_time(heat, structure, y, travel, v, start, jerk, length);
        if (leave < length) {
            travel *= leave / length;
            length = leave;
            turns = false;
        }
        const double speed = turns ? 0.0 : fabs(v + length * (start + 0.5 * length * jerk));
        /* what an odd length brings is a part of what the regular one would: its modes are at hand */
        const double part = length / regular;
        const double closing = opening + (flux * speed - opening) / part;
        place = *level;
        prepare(heat, place, regular);
        expect(heat, structure, place, y + 0.5 * travel, opening, closing);
        if (part != 1.0)
            mix(heat, structure, part, heat->expected);
        last = mean_coefficient(law, structure, speed, heat->expected);
        bend = 0.0;
        if (fabs(last - friction) > tolerance * last) {
            mix(heat, structure, 0.5, heat->between);
            const double half_speed = fabs(v + 0.5 * length * (start + 0.25 * length * jerk));
            const double central = mean_coefficient(law, structure, half_speed, heat->between);
            bend = central - 0.5 * (friction + last);
            if (fabs(bend) > tolerance * last && *level < FINEST_LEVEL) {
                ++*level;
                continue;
            }
        }
        if (fabs(bend) < 0.2 * tolerance * last && *level > coarsest && !fresh)
            --*level;
        break;
    }

    double per_length = 1.0 / length;
    const double slope = (last - friction + 4.0 * bend) * per_length;
    const double curve = bend * (-4.0 * per_length * per_length);
    const double pull = -side * structure->gravity;
    const double push_rate = -push.rate + pull * slope;
    const double push_curve = pull * curve;
    struct swing swung = swing(structure->restoring, length, v, start, push_rate, push_curve);
    if (turns || v * swung.velocity < 0.0) {
        const double furthest = smaller(room, 2.0 * length);
        turns = polish_turn(structure->restoring, &length, furthest, v, start, push_rate, push_curve);
        swung = swing(structure->restoring, length, v, start, push_rate, push_curve);
        last = friction + length * (slope + length * curve);
        per_length = 1.0 / length;
    }

    const double reach = side * last * structure->reach;
    if (side * (swung.displacement - reach + motion.elongation) < 0.0) {
        if (!fresh)
            return (struct advance){{y, v, motion.elongation, 0}, 0.0, 0.0, 0.0, friction, NAN};
        if (*level < FINEST_LEVEL) {
            ++*level;
            return (struct advance){motion, 0.0, 0.0, 0.0, friction, NAN};
        }
    }

    const double end = y + swung.displacement;
    const double speed = turns ? 0.0 : swung.velocity;
    const double rubbed = work(friction, slope, curve, length, swung);
    const double closing = structure->pressure * last * fabs(speed);
    const double missing = structure->pressure * fabs(rubbed) * per_length - 0.5 * (opening + closing);
    if (length != regular)
        place = ODD_LENGTH;
    prepare(heat, place, length);
    note_ratios(law, structure, fabs(speed), heat->expected, heat->ratio);
    heat_up(heat, structure, place, y + 0.5 * swung.displacement, opening + missing, closing + missing, closing);
    const double stored = 0.5 * structure->elastic * (reach * reach - motion.elongation * motion.elongation);
    return (struct advance){
        {end, speed, reach, turns ? 0 : motion.side},
        length,
        -work(push.now, push.rate, 0.0, length, swung),
        -pull * rubbed - stored,
        last,
        turns ? end : NAN,
    };
}

/* ----- march ----- */

static inline void note(struct outcome *restrict outcome, const struct structure *structure, const struct advance *advance, bool slid,
                        const struct heat *heat)
{
    const struct motion *motion = &advance->motion;
    outcome->input += advance->input;
    outcome->hysteretic += advance->hysteretic;
    if (!isnan(advance->turning)) {
        outcome->peak_displacement = larger(outcome->peak_displacement, fabs(advance->turning));
        outcome->peak_change = larger(outcome->peak_change, fabs(advance->turning - outcome->turning));
        outcome->turning = advance->turning;
    }
    outcome->peak_velocity = larger(outcome->peak_velocity, fabs(motion->velocity));
    const double force = structure->restoring * motion->displacement + structure->elastic * motion->elongation;
    outcome->peak_force = larger(outcome->peak_force, fabs(force));
    for (int i = 0; i < structure->plates; i++)
        outcome->peak_temperature = larger(outcome->peak_temperature, heat->present[i]);
    if (slid || motion->side != 0)
        outcome->least_friction = smaller(outcome->least_friction, advance->friction);
}

static inline void record(double *restrict line, const struct structure *structure, const struct motion *motion,
                          double friction, const struct outcome *restrict outcome, const struct heat *heat)
{
    line[DISPLACEMENT] = motion->displacement;
    line[VELOCITY] = motion->velocity;
    line[ELONGATION] = motion->elongation;
    line[FRICTION] = friction;
    line[SIDE] = motion->side;
    line[INPUT] = outcome->input;
    line[HYSTERETIC] = outcome->hysteretic;
    for (int i = 0; i < structure->plates; i++)
        line[TEMPERATURE + i] = heat->present[i];
}

static bool rests(const struct law *law, const struct structure *structure, const struct heat *heat,
                  const struct motion *motion)
{
    if (motion->side != 0)
        return false;
    const double stiffness = structure->restoring + structure->elastic;
    const double stuck = motion->displacement - motion->elongation;
    const double centre = structure->elastic * stuck / stiffness;
    const double amplitude = hypot(motion->displacement - centre, motion->velocity / sqrt(stiffness));
    const double speeds[2] = {0.0, amplitude * sqrt(stiffness)};
    for (int k = 0; k < 2; k++) {
        const double friction = mean_coefficient(law, structure, speeds[k], heat->present);
        if (fabs(centre - stuck) + amplitude >= friction * structure->reach)
            return false;
    }
    return true;
}

/* Respond from rest to the samples of the ground acceleration; return how it ended, and the samples done in `done`. */
enum status march(const struct law *law, const struct structure *structure, const struct steel *steel, size_t samples,
          const double *restrict acceleration, double interval, int coarsest, size_t free_from,
          double tolerance, struct outcome *restrict outcome, size_t rows, double *restrict histories, size_t *restrict done)
{
    struct heat heat;
    heat.steel = steel;
    for (int i = 0; i < 2; i++) {
        heat.present[i] = steel->ambient;
        heat.ratio[i] = 1.0;
        for (int j = 0; j < MODES; j++)
            heat.modes[i][j] = 0.0;
    }
    for (int place = 0; place <= ODD_LENGTH; place++)
        heat.steps[place].length = NAN;
    struct motion motion = {0.0, 0.0, 0.0, 0};
    int level = coarsest;
    bool fresh = false;
    double friction = 0.0;
    enum status status = DONE;
    *outcome = (struct outcome){.peak_temperature = steel->ambient, .least_friction = INFINITY};
    *done = 0;
    for (size_t i = 0; i + 1 < samples; i++) {
        const double rate = (acceleration[i + 1] - acceleration[i]) / interval;
        double elapsed = 0.0;
        int steps = 0;
        while (elapsed < interval) {
            const double room = interval - elapsed;
            const struct push push = {acceleration[i] + rate * elapsed, rate};
            struct advance advance;
            if (motion.side == 0) {
                advance = stick_step(law, structure, &heat, motion, push, room, interval);
                fresh = advance.motion.side != 0;
            } else {
                advance = slide_step(law, structure, &heat, fresh, motion, push, room, interval, &level, coarsest,
                                     tolerance);
                fresh = fresh && advance.length == 0.0;
            }
            const bool slid = motion.side != 0 && advance.length > 0.0;
            motion = advance.motion;
            friction = advance.friction;
            elapsed = room - advance.length <= 1e-12 * interval ? interval : elapsed + advance.length;
            note(outcome, structure, &advance, slid, &heat);
            if (++steps > MOST_STEPS_PER_SAMPLE)
                return NO_PROGRESS;
        }
        *done = i + 1;
        outcome->steps += steps;
        if (i + 1 < rows)
            record(histories + (i + 1) * (TEMPERATURE + structure->plates), structure, &motion, friction, outcome,
                   &heat);
        if (i + 1 >= free_from && rests(law, structure, &heat, &motion)) {
            status = AT_REST;
            break;
        }
    }
    outcome->peak_displacement = larger(outcome->peak_displacement, fabs(motion.displacement));
    return status;
}
