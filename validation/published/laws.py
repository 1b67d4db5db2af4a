"""Integrators and hidden laws (numba). Requires numpy, scipy, numba."""
import numpy as np
from numba import njit
from math import pi, sqrt, exp, sin, cos, tanh, sinh, log

# ---------------------------------------------------------------- generic ODE driver
def make_ode(rhs):
    @njit
    def run(ny, inp, dt, m, par):
        n, k = inp.shape
        y = np.zeros(ny); out = np.zeros((n, ny)); dout = np.zeros((n, ny))
        k1 = np.zeros(ny); k2 = np.zeros(ny); k3 = np.zeros(ny); k4 = np.zeros(ny)
        h = dt/m
        for i in range(n):
            rhs(y, inp[i], par, k1)
            out[i] = y; dout[i] = k1
            if i == n-1: break
            for j in range(m):
                a0 = inp[i]+(inp[i+1]-inp[i])*(j/m)
                ah = inp[i]+(inp[i+1]-inp[i])*((j+0.5)/m)
                a1 = inp[i]+(inp[i+1]-inp[i])*((j+1.0)/m)
                rhs(y, a0, par, k1)
                rhs(y+0.5*h*k1, ah, par, k2)
                rhs(y+0.5*h*k2, ah, par, k3)
                rhs(y+h*k3, a1, par, k4)
                y = y+h/6.0*(k1+2*k2+2*k3+k4)
        return out, dout
    return run

@njit
def H(z, uy, v):
    """Bouc-Wen n=1, beta=gamma=0.5/uy"""
    s = 1.0 if z*v > 0 else (-1.0 if z*v < 0 else 0.0)
    return 1.0-abs(z)/uy*(0.5+0.5*s)

# ---------------------------------------------------------------- rig laws
@njit
def bw(u, m, ko, Q, al):
    n = len(u); F = np.zeros(n); z = 0.0; uy = Q/((1-al)*ko)
    for i in range(1, n):
        du = (u[i]-u[i-1])/m
        for j in range(m):
            h1 = H(z, uy, du); zp = z+h1*du
            z += 0.5*(h1+H(zp, uy, du))*du
        F[i] = al*ko*u[i]+(1-al)*ko*z
    return F

@njit
def slip_lock(u, m, ko, Q, al, Rs, sig, lam):
    """Sivaselvan-Reinhorn slip-lock spring in series with the Bouc-Wen spring"""
    n = len(u); F = np.zeros(n); z = 0.0; uy = Q/((1-al)*ko); up = 0.0; um = 0.0
    for i in range(1, n):
        du = (u[i]-u[i-1])/m
        for j in range(m):
            uu = u[i-1]+du*(j+0.5)
            up = max(up, uu); um = min(um, uu)
            s = Rs*max(up-um-2*uy, 0.0)
            sg = 1.0 if du > 0 else -1.0
            ze = z/uy
            g = sqrt(2/pi)*s/sig*exp(-0.5*((ze-lam*sg)/sig)**2)
            h = H(z, uy, du)
            zp = z+h/(1+g*h/uy)*du
            zm = 0.5*(z+zp); ze = zm/uy
            g = sqrt(2/pi)*s/sig*exp(-0.5*((ze-lam*sg)/sig)**2)
            h = H(zm, uy, du)
            z += h/(1+g*h/uy)*du
        F[i] = al*ko*u[i]+(1-al)*ko*z
    return F

@njit
def j2(ux, uy, kI, Q, al):
    n = len(ux); F = np.zeros((n, 2)); px = 0.0; py = 0.0; k0 = (1-al)*kI
    for i in range(n):
        qx = k0*(ux[i]-px); qy = k0*(uy[i]-py); q = sqrt(qx*qx+qy*qy)
        if q > Q:
            r = Q/q; qx *= r; qy *= r
            px = ux[i]-qx/k0; py = uy[i]-qy/k0
        F[i, 0] = qx+al*kI*ux[i]; F[i, 1] = qy+al*kI*uy[i]
    return F

@njit
def lrb_heat(u, dt, m, kI, Q, al, on, E2, a, hL, tsh, R):
    """bilinear LRB; Kalpakidis-Constantinou lead-plug heating with radial conduction into the shims (finite volumes)"""
    n = len(u); F = np.zeros(n); T = np.zeros(n); N = 24
    k0 = (1-al)*kI; up = 0.0
    Tc = np.zeros(N); Tn = np.zeros(N); TL = 0.0
    dr = (R-a)/N; ks = 50.0; rcs = 7900.0*450.0; CL = 11360.0*130.0*pi*a*a*hL
    h = dt/m
    for i in range(1, n):
        for j in range(m):
            uu = u[i-1]+(u[i]-u[i-1])*(j+1)/m
            q = k0*(uu-up); Qc = Q*exp(-E2*TL) if on > 0 else Q
            w = 0.0
            if abs(q) > Qc:
                sg = 1.0 if q > 0 else -1.0
                upn = uu-sg*Qc/k0; w = abs(upn-up)*Qc; up = upn; q = sg*Qc
            if on > 0:
                gi = 2*pi*a*tsh*ks/(dr/2)
                fl = gi*(TL-Tc[0])
                TLn = TL+(w-fl*h)/CL
                f_in = fl
                for c in range(N):
                    rr = a+(c+1)*dr
                    fo = 0.0
                    if c < N-1: fo = 2*pi*rr*tsh*ks*(Tc[c]-Tc[c+1])/dr
                    vol = pi*(rr*rr-(rr-dr)**2)*tsh
                    Tn[c] = Tc[c]+h*(f_in-fo)/(rcs*vol)
                    f_in = fo
                for c in range(N): Tc[c] = Tn[c]
                TL = TLn
        F[i] = q+al*kI*u[i]; T[i] = TL
    return F, T

@njit
def tilt_eyring(u, dt, P, m, ko, Q, al, onA, onR, l, Kth0, Cs, a_s, Cth, k1, v0, q0):
    """Nagarajaiah-Ferrell macro model (shear spring on tilting column); Ree-Eyring Maxwell arm in parallel with the shear spring"""
    n = len(u); F = np.zeros(n); uy = Q/((1-al)*ko)
    z = 0.0; s = 0.0; th = 0.0; q = 0.0; h = dt/m
    for i in range(1, n):
        for j in range(m):
            uu = u[i-1]+(u[i]-u[i-1])*(j+1)/m
            # one-step solve for theta, z explicit in the shear increment
            x0 = th; x1 = th
            for it in range(30):
                f0 = 0.0; d0 = 0.0
                for p in range(2):
                    x = x0 if p == 0 else x0+1e-7
                    sn = (uu-l*sin(x))/cos(x) if onA > 0 else uu
                    ds = sn-s
                    zz = z+H(z+0.5*H(z, uy, ds)*ds, uy, ds)*ds
                    kf = al*ko*(1-Cs*tanh(a_s*abs(sn)/l)) if onA > 0 else al*ko
                    qq = q
                    if onR > 0: qq = q+k1*ds-k1*v0*sinh(q/q0)*h
                    fs = kf*sn+(1-al)*ko*zz+qq
                    if onA > 0:
                        FF = (fs-P*sin(x))/cos(x)
                        Kt = Kth0*(1-Cth*min(abs(sn)/l, 1.0))
                        r = Kt*x-P*(l*sin(x)+sn*cos(x))-FF*(l*cos(x)-sn*sin(x))
                    else:
                        FF = fs; r = 0.0
                    if p == 0: f0 = r
                    else: d0 = (r-f0)/1e-7
                if onA <= 0: break
                dx = -f0/d0
                x0 += dx
                if abs(dx) < 1e-12: break
            sn = (uu-l*sin(x0))/cos(x0) if onA > 0 else uu
            ds = sn-s
            z = z+H(z+0.5*H(z, uy, ds)*ds, uy, ds)*ds
            if onR > 0: q = q+k1*ds-k1*v0*sinh(q/q0)*h
            kf = al*ko*(1-Cs*tanh(a_s*abs(sn)/l)) if onA > 0 else al*ko
            s = sn; th = x0 if onA > 0 else 0.0
            fs = kf*s+(1-al)*ko*z+q
            FF = (fs-P*sin(th))/cos(th) if onA > 0 else fs
        F[i] = FF
    return F

@njit
def void_p(w, f0, mu):
    lb = (1+w)**(1/3); la = (1+w/f0)**(1/3)
    return 0.5*mu*((4/lb+lb**-4)-(4/la+la**-4))

@njit
def cavity(u, m, ko, Q, al, on, A, t, mu, f0, Dm, ad):
    """Bouc-Wen bearing in series with a population of neo-Hookean hollow spheres (cavitation instability),
    whose modulus is damaged by the largest void growth"""
    n = len(u); F = np.zeros(n); uy = Q/((1-al)*ko); z = 0.0; ub = 0.0; wm = 0.0; w = 0.0
    for i in range(1, n):
        for j in range(m):
            uu = u[i-1]+(u[i]-u[i-1])*(j+1)/m
            md = mu*(1-Dm*(1-exp(-ad*wm)))
            # compatibility uu = ub + w t, equilibrium Fbw(ub) = A p(w)
            lo = 0.0; hi = max(w*3, 1e-6)+max(uu, 0.0)/t
            db = uu-ub; zz = z+H(z+0.5*H(z, uy, db)*db, uy, db)*db
            wn = 0.0
            if on > 0 and al*ko*uu+(1-al)*ko*zz > 0:
                for it in range(60):
                    wn = 0.5*(lo+hi)
                    db = uu-wn*t-ub
                    zz = z+H(z+0.5*H(z, uy, db)*db, uy, db)*db
                    r = al*ko*(uu-wn*t)+(1-al)*ko*zz-A*void_p(wn, f0, md)
                    if r > 0: lo = wn
                    else: hi = wn
            w = wn
            db = uu-w*t-ub
            z = z+H(z+0.5*H(z, uy, db)*db, uy, db)*db
            ub = uu-w*t
            wm = max(wm, w)
        F[i] = al*ko*ub+(1-al)*ko*z
    return F

@njit
def steel01(u, E, Fy, b):
    n = len(u); F = np.zeros(n); up = 0.0; k = (1-b)*E; q0 = (1-b)*Fy
    for i in range(n):
        q = k*(u[i]-up)
        if abs(q) > q0:
            q = q0 if q > 0 else -q0
            up = u[i]-q/k
        F[i] = q+b*E*u[i]
    return F

@njit
def steel_degr(u, m, E, Fy, b, uult, b1, b2, Hult):
    """Sivaselvan-Reinhorn strength degradation: ductility and dissipated energy, separate envelopes for the two signs"""
    n = len(u); F = np.zeros(n); up = 0.0; k = (1-b)*E; q0 = (1-b)*Fy
    xp = 0.0; xm = 0.0; En = 0.0
    for i in range(1, n):
        for j in range(m):
            uu = u[i-1]+(u[i]-u[i-1])*(j+1)/m
            xp = max(xp, uu); xm = max(xm, -uu)
            fe = 1-b2/(1-b2)*En/Hult
            cp = q0*max((1-(min(xp/uult, 1.0))**(1/b1))*fe, 0.2)
            cm = q0*max((1-(min(xm/uult, 1.0))**(1/b1))*fe, 0.2)
            q = k*(uu-up)
            if q > cp:
                upn = uu-cp/k; En += abs(upn-up)*cp; up = upn; q = cp
            elif q < -cm:
                upn = uu+cm/k; En += abs(upn-up)*cm; up = upn; q = -cm
        F[i] = q+b*E*u[i]
    return F

@njit
def qi_boyce(u, m, ko, Q, al, h, v0, vss, A, lock, frac):
    """Qi-Boyce: soft-domain fraction v_s grows with the largest local chain stretch, amplified stretch X(v_s)"""
    n = len(u); F = np.zeros(n); z = 0.0; uy = Q/((1-al)*ko); vs = v0; L = 1.0
    Xss = 1+3.5*(1-vss)+18*(1-vss)**2
    for i in range(1, n):
        for j in range(m):
            uo = u[i-1]+(u[i]-u[i-1])*j/m
            uu = u[i-1]+(u[i]-u[i-1])*(j+1)/m
            du = uu-uo
            h1 = H(z, uy, du); zp = z+h1*du
            z += 0.5*(h1+H(zp, uy, du))*du
            X = 1+3.5*(1-vs)+18*(1-vs)**2
            lc = sqrt(1+X*(uu/h)**2/3)
            if lc > L:
                dL = lc-L
                vs += A*(vss-vs)*(lock-1)/max(lock-L, 0.05)**2*dL
                vs = min(vs, vss)
                L = lc
        X = 1+3.5*(1-vs)+18*(1-vs)**2
        g = vs*X/(vss*Xss)
        F[i] = g*al*ko*u[i]+(1+frac*(g-1))*(1-al)*ko*z
    return F

@njit
def fps(u, N, m, R, E, Q0, N0, p0, mumax, dmu, on):
    """sliding pendulum, friction and restoring force follow N(t); Tsopelas-Constantinou-Reinhorn pressure law mu = mu_max - dmu tanh(p)"""
    n = len(u); F = np.zeros(n); up = 0.0
    r0 = mumax-dmu*tanh(p0)
    for i in range(1, n):
        for j in range(m):
            f = (j+1)/m
            uu = u[i-1]+(u[i]-u[i-1])*f
            NN = N[i-1]+(N[i]-N[i-1])*f if on > 0 else N0
            c = Q0
            if on > 0: c = Q0*(NN/N0)*(mumax-dmu*tanh(p0*NN/N0))/r0
            q = E*(uu-up)
            if abs(q) > c:
                q = c if q > 0 else -c
                up = uu-q/E
        F[i] = q+NN*R*u[i]
    return F

@njit
def springpot(u, dt, al):
    """Gruenwald-Letnikov derivative of order al"""
    n = len(u); g = np.zeros(n); g[0] = 1.0
    for k in range(1, n): g[k] = g[k-1]*(k-1-al)/k
    D = np.zeros(n); c = dt**(-al)
    for i in range(n):
        s = 0.0
        for k in range(i+1): s += g[k]*u[i-k]
        D[i] = s*c
    return D

@njit
def fung_heat(u, dt, m, ko, Q, al, onS, onH, b, h, Th, C1, C2, G12, G20):
    """Fung exponential stiffening; Arrhenius softening with a two-node thermal network (rubber core, plates)"""
    n = len(u); F = np.zeros(n); z = 0.0; uy = Q/((1-al)*ko); T1 = 0.0; T2 = 0.0; Ta = 293.0
    TT = np.zeros(n)
    hh = dt/m
    for i in range(1, n):
        du = (u[i]-u[i-1])/m
        for j in range(m):
            h1 = H(z, uy, du); zp = z+h1*du
            z += 0.5*(h1+H(zp, uy, du))*du
            if onH > 0:
                fq = exp(Th*(1/(Ta+T1)-1/Ta))
                w = (1-al)*ko*z*fq*(1-H(z, uy, du))*du
                if w < 0: w = 0.0
                T1 += (w/C1)-(G12*(T1-T2)/C1)*hh
                T2 += (G12*(T1-T2)-G20*T2)/C2*hh
        fq = exp(Th*(1/(Ta+T1)-1/Ta)) if onH > 0 else 1.0
        fe = exp(0.35*Th*(1/(Ta+T1)-1/Ta)) if onH > 0 else 1.0
        st = exp(b*(u[i]/h)**2) if onS > 0 else 1.0
        F[i] = al*ko*u[i]*st*fe+(1-al)*ko*z*fq
        TT[i] = T1
    return F, TT

# ---------------------------------------------------------------- structures
@njit
def invL(x):   # inverse Langevin, Cohen-Pade
    return x*(3-x*x)/(1-x*x)

@njit
def stick(y, a, p, dy):
    """isolated stick: base law (Bouc-Wen n=1 + base dashpot), linear storeys; mode switches one concealed law on.
    p: 0 n 1 ko 2 uy 3 al 4 mode 5.. m 10.. k 14.. c 18 cb 20.. extras; y: x v z extras"""
    n = int(p[0]); mode = int(p[4]); ag = a[0]
    ko = p[1]; uy = p[2]; al = p[3]
    x0 = y[0]; v0 = y[n]; z = y[2*n]; e = 2*n+1
    el = al*ko*x0
    if mode == 1:      # eight-chain (Arruda-Boyce) rubber in simple shear, Cohen-Pade inverse Langevin
        N = p[21]; g = x0/p[20]
        lc = sqrt(1+g*g/3); r = min(lc/sqrt(N), 0.97); r0 = 1/sqrt(N)
        el *= (invL(r)/lc)/(invL(r0))
    f = el+(1-al)*ko*z+p[18]*v0
    dy[2*n] = H(z, uy, v0)*v0
    mb = p[5]
    if mode == 5:      # regularised rate-and-state friction, ageing law
        W = p[20]; aa = p[21]; bb = p[22]; f0 = p[23]; vs = p[24]; Dc = p[25]
        th = exp(y[e])   # log state
        arg = v0/(2*vs)*exp((f0+bb*log(vs*th/Dc))/aa)
        s = log(arg+sqrt(arg*arg+1)) if arg >= 0 else -log(-arg+sqrt(arg*arg+1))
        f += W*aa*s
        dy[e] = 1/th-abs(v0)/Dc
        if th > 20.0 and dy[e] > 0: dy[e] = 0.0
    if mode == 4:      # two convective modes taken out of the rigid liquid
        for j in range(2):
            mc = p[20+3*j]; w = p[21+3*j]; zt = p[22+3*j]
            xs = y[e+2*j]; vc = y[e+2*j+1]
            fc = mc*(w*w*(xs-x0)+2*zt*w*(vc-v0))
            f -= fc; mb -= mc
            dy[e+2*j] = vc; dy[e+2*j+1] = -fc/mc-ag
    # storeys
    up = 0.0
    for i in range(n-1, 0, -1):
        k = p[10+i-1]; c = p[14+i-1]
        d = y[i]-y[i-1]; dv = y[n+i]-y[n+i-1]
        fs = k*d+c*dv
        if mode == 2:  # Biot's hysteretic damping as a ladder of Maxwell elements
            for j in range(5):
                q = y[e+5*(i-1)+j]
                fs += q
                dy[e+5*(i-1)+j] = p[20]*k*dv-p[21+j]*q
        if mode == 3 and i == 1:   # first storey yields: smooth hysteresis with pivot-rule stiffness degradation and kinematic part
            Fy = p[20]; ah = p[21]; pv = p[22]
            Fh = y[e]; Fz = (1-ah)*Fy
            Ft = Fh+ah*k*d
            R = (abs(Ft)+pv*Fy)/(k*abs(d)+pv*Fy)
            R = min(R, 1.0)
            s = 1.0 if Fh*dv > 0 else 0.0
            dy[e] = (R-ah)*k*(1-(abs(Fh)/Fz)**4*s)*dv
            fs = Ft+c*dv
        dy[i] = y[n+i]
        dy[n+i] = -ag-(fs-up)/p[5+i]
        up = fs
    dy[0] = v0
    dy[n] = -ag-(f-up)/mb
run_stick = make_ode(stick)

@njit
def spans(y, a, p, dy):
    """pier P, decks A and B on their own bearings; Jankowski's non-linear viscoelastic contact between the decks
    p: 0 mP 1 mA 2 mB 3 kP 4 cP 5 ko 6 uy 7 al 8 rB 9 on 10 gap 11 beta 12 xi"""
    xP, xA, xB, vP, vA, vB = y[0], y[1], y[2], y[3], y[4], y[5]
    al = p[7]; ko = p[5]; uy = p[6]
    fP = p[3]*xP+p[4]*vP
    fa = al*ko*xA+(1-al)*ko*y[6]; dy[6] = H(y[6], uy, vA)*vA
    fpa = al*ko*(xA-xP)+(1-al)*ko*y[7]; dy[7] = H(y[7], uy, vA-vP)*(vA-vP)
    fb = p[8]*(al*ko*xB+(1-al)*ko*y[8]); dy[8] = H(y[8], uy, vB)*vB
    fpb = p[8]*(al*ko*(xB-xP)+(1-al)*ko*y[9]); dy[9] = H(y[9], uy, vB-vP)*(vB-vP)
    c = 0.0
    if p[9] > 0:
        d = xA-xB-p[10]; dv = vA-vB
        if d > 0:
            c = p[11]*d**1.5
            if dv > 0: c += 2*p[12]*sqrt(p[11]*sqrt(d)*p[1]*p[2]/(p[1]+p[2]))*dv
    dy[0] = vP; dy[1] = vA; dy[2] = vB
    dy[3] = -a[0]-(fP-fpa-fpb)/p[0]
    dy[4] = -a[0]-(fa+fpa+c)/p[1]
    dy[5] = -a[0]-(fb+fpb-c)/p[2]
run_spans = make_ode(spans)

@njit
def plan(y, a, p, dy):
    """rigid slab on four bearings, uncoupled springs; p: 0 m 1 J 2 ko 3 uy 4 al 5 ex 6 ey 7..10 factor of stiffness 11..14 factor of strength
    15..18 x 19..22 y"""
    m = p[0]; J = p[1]; Fx = 0.0; Fy = 0.0; M = 0.0; al = p[4]
    for b in range(4):
        X = p[15+b]; Y = p[19+b]
        dx = y[0]-Y*y[2]; d2 = y[1]+X*y[2]
        vx = y[3]-Y*y[5]; v2 = y[4]+X*y[5]
        ko = p[2]*p[7+b]; uy = p[3]*p[11+b]/p[7+b]
        fx = al*ko*dx+(1-al)*ko*y[6+2*b]; fy = al*ko*d2+(1-al)*ko*y[7+2*b]
        dy[6+2*b] = H(y[6+2*b], uy, vx)*vx; dy[7+2*b] = H(y[7+2*b], uy, v2)*v2
        Fx += fx; Fy += fy; M += -Y*fx+X*fy
    ex = p[5]; ey = p[6]
    dy[0] = y[3]; dy[1] = y[4]; dy[2] = y[5]
    w2 = y[5]**2
    rx = -Fx-m*a[0]+m*ex*w2; ry = -Fy-m*a[1]+m*ey*w2
    rt = -M+m*ey*a[0]-m*ex*a[1]
    # m ax - m ey at = rx ; m ay + m ex at = ry ; (J+m e2) at - m ey ax + m ex ay = rt
    at = (rt+ey*rx-ex*ry)/J
    dy[3] = rx/m+ey*at; dy[4] = ry/m-ex*at; dy[5] = at
run_plan = make_ode(plan)
