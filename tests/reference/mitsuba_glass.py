"""A plugin for render_mitsuba.py of what Mitsuba has not: absorption without chance.

Import it after the choice of a variant.
"""
import drjit as dr
import mitsuba as mi

class Absorbing(mi.SamplingIntegrator):
    """Mitsuba's `path` (same depths, same weights, no roulette), in media that absorb and do not scatter: exp(-sigma·length).

    Mitsuba's `volpath` draws where light is absorbed, with the extinction of a colour drawn beforehand: the same mean, but far noisier.
    Lengths are between surface points, not between where rays start and end, which Mitsuba moves by 1e-4.
    """
    def __init__(self, props):
        mi.SamplingIntegrator.__init__(self, props)
        self.max_depth = int(props['max_depth'])
    @dr.syntax
    def sample(self, scene, sampler, ray, medium=None, active=True):
        ray, active = mi.Ray3f(ray), mi.Bool(active)
        result, throughput = mi.Spectrum(0), mi.Spectrum(1)
        depth, within = mi.UInt32(0), dr.zeros(mi.MediumPtr)
        last, last_pdf, last_delta = dr.zeros(mi.Interaction3f), mi.Float(1), mi.Bool(True)
        context = mi.BSDFContext()
        while active:
            si = scene.ray_intersect(ray, active)
            absorbed = active & si.is_valid() & (within != None)
            at = dr.zeros(mi.MediumInteraction3f)
            sigma = within.get_scattering_coefficients(at, absorbed)[2]
            throughput[absorbed] *= dr.exp(-sigma * dr.norm(si.p - last.p))
            seen = mi.DirectionSample3f(scene, si, last)
            light_pdf = scene.pdf_emitter_direction(last, seen, active & ~last_delta)
            weight = dr.select(last_delta, 1, square_share(last_pdf, light_pdf))
            result += dr.select(active, throughput * weight * si.emitter(scene).eval(si, active), 0)
            active &= si.is_valid() & (depth + 1 < self.max_depth)
            bsdf = si.bsdf(ray)
            lit = active & mi.has_flag(bsdf.flags(), mi.BSDFFlags.Smooth)
            light, light_weight = scene.sample_emitter_direction(si, sampler.next_2d(lit), True, lit)
            lit &= light.pdf != 0
            wo = si.to_local(light.d)
            value, pdf = bsdf.eval_pdf(context, si, wo, lit)
            # Not absorbed: the boundary of a medium hides what is beyond it, and no light may be in one.
            result += dr.select(lit, throughput * value * light_weight * square_share(light.pdf, pdf), 0)
            drawn, drawn_weight = bsdf.sample(context, si, sampler.next_1d(active), sampler.next_2d(active), active)
            throughput[active] *= drawn_weight
            ray = si.spawn_ray(si.to_world(drawn.wo))
            within[active & si.is_medium_transition()] = si.target_medium(ray.d)
            last, last_pdf, last_delta = mi.Interaction3f(si), drawn.pdf, mi.has_flag(drawn.sampled_type, mi.BSDFFlags.Delta)
            depth += 1
            active &= dr.any(throughput != 0)
        return result, mi.Bool(True), []

def square_share(a, b):
    """Power heuristic."""
    return dr.select(a > 0, dr.square(a) / (dr.square(a) + dr.square(b)), 0)

mi.register_integrator('absorbing', lambda p: Absorbing(p))
