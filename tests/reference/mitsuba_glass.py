"""Plugins for render_mitsuba.py of what Mitsuba has not: absorption without chance, and the thin wall of glTF.

Import it after the choice of a variant.
"""
import json, math
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

class ThinWall(mi.BSDF):
    """glTF's thin wall (KHR_materials_transmission), smooth, of a dielectric: one interface.

    It reflects F, by Schlick, as a mirror; of the rest `transmission` goes straight on, coloured by `base`, and what is left is diffuse:
    (1 - F(half vector))·base/π, as glTF's opaque dielectric has it. `thindielectric` has two interfaces: 2F/(1 + F), and by Fresnel.
    """
    def __init__(self, props):
        mi.BSDF.__init__(self, props)
        self.base = mi.Color3f([float(x) for x in json.loads(props['base'])])
        ior = float(props['ior']); self.f0 = ((ior - 1) / (ior + 1)) ** 2; self.transmission = float(props['transmission'])
        both = mi.BSDFFlags.FrontSide | mi.BSDFFlags.BackSide
        self.m_components = [mi.BSDFFlags.DeltaReflection | both, mi.BSDFFlags.DeltaTransmission | both]
        if self.transmission < 1: self.m_components.append(mi.BSDFFlags.DiffuseReflection | both)
        self.m_flags = self.m_components[0]
        for c in self.m_components[1:]: self.m_flags |= c
    def fresnel(self, cos): return self.f0 + (1 - self.f0) * dr.power(1 - dr.minimum(cos, 1), 5)
    def diffuse(self, wi, wo):
        F = self.fresnel(dr.dot(wi, dr.normalize(wi + wo)))
        return (1 - self.transmission) * (1 - F) * self.base * dr.abs(mi.Frame3f.cos_theta(wo)) / math.pi
    def share(self, wi): return (1 - self.transmission) * (1 - self.fresnel(dr.abs(mi.Frame3f.cos_theta(wi))))
    def sample(self, ctx, si, s1, s2, active):
        cos = mi.Frame3f.cos_theta(si.wi); F = self.fresnel(dr.abs(cos)); diffuse = self.share(si.wi)
        reflects, scatters = s1 < F, s1 >= 1 - diffuse
        lambert = mi.warp.square_to_cosine_hemisphere(s2); lambert.z = dr.mulsign(lambert.z, cos)
        bs = dr.zeros(mi.BSDFSample3f)
        bs.wo = dr.select(reflects, mi.reflect(si.wi), dr.select(scatters, lambert, -si.wi)); bs.eta = 1.0
        bs.pdf = dr.select(reflects, F, dr.select(scatters, diffuse * dr.abs(lambert.z) / math.pi, 1 - F - diffuse))
        flag = lambda f: mi.UInt32(+f)
        bs.sampled_type = dr.select(reflects, flag(mi.BSDFFlags.DeltaReflection),
                                    dr.select(scatters, flag(mi.BSDFFlags.DiffuseReflection), flag(mi.BSDFFlags.DeltaTransmission)))
        bs.sampled_component = dr.select(reflects, mi.UInt32(0), dr.select(scatters, mi.UInt32(2), mi.UInt32(1)))
        active &= (cos != 0) & (bs.pdf > 0)
        scattered = self.diffuse(si.wi, bs.wo) / dr.maximum(bs.pdf, 1e-30)
        return bs, dr.select(active, dr.select(reflects, mi.Color3f(1), dr.select(scatters, scattered, self.base)), 0)
    def above(self, value, si, wo, active):
        return dr.select(active & (mi.Frame3f.cos_theta(si.wi) * mi.Frame3f.cos_theta(wo) > 0), value, 0)
    def eval(self, ctx, si, wo, active): return self.above(self.diffuse(si.wi, wo), si, wo, active)
    def pdf(self, ctx, si, wo, active): return self.above(self.share(si.wi) * dr.abs(mi.Frame3f.cos_theta(wo)) / math.pi, si, wo, active)
    def eval_pdf(self, ctx, si, wo, active): return self.eval(ctx, si, wo, active), self.pdf(ctx, si, wo, active)
    def to_string(self): return 'ThinWall[]'

mi.register_integrator('absorbing', lambda p: Absorbing(p))
mi.register_bsdf('thinwall', lambda p: ThinWall(p))
