fn main() {
    let a = seamster::scene::DressForm::default().build().unwrap();
    for (k, v) in &a.landmarks {
        println!("{k:16} {:.4} {:.4} {:.4}", v.x, v.y, v.z);
    }
    let ys: Vec<f64> = a.surface.vertices.iter().map(|v| v.y).collect();
    println!(
        "{} v {} t  y {}..{}",
        a.surface.vertices.len(),
        a.surface.triangles.len(),
        ys.iter().cloned().fold(9., f64::min),
        ys.iter().cloned().fold(-9., f64::max)
    );
    std::fs::write("/tmp/avatar.glb", seamster::export::avatar_glb(&a.surface)).unwrap();
    // hull girth of slices
    let mut y = 0.75;
    while y < 1.45 {
        let mut pts = vec![];
        for t in &a.surface.triangles {
            let p = t.map(|i| a.surface.vertices[i]);
            for k in 0..3 {
                let (q, r) = (p[k], p[(k + 1) % 3]);
                if (q.y - y) * (r.y - y) < 0.0 {
                    let s = (y - q.y) / (r.y - q.y);
                    pts.push([q.x + s * (r.x - q.x), q.z + s * (r.z - q.z)]);
                }
            }
        }
        let w = |k: usize| {
            (
                pts.iter().map(|p| p[k]).fold(9., f64::min),
                pts.iter().map(|p| p[k]).fold(-9., f64::max),
            )
        };
        // support-function perimeter = integral of width over pi
        let n = 720;
        let mut per = 0.0;
        for i in 0..n {
            let t = std::f64::consts::TAU * i as f64 / n as f64;
            let h = pts
                .iter()
                .map(|p| p[0] * t.cos() + p[1] * t.sin())
                .fold(-9., f64::max);
            per += h * std::f64::consts::TAU / n as f64;
        }
        // front share: perimeter of part z > z of widest
        println!("y {y:.3} girth {per:.4} x {:?} z {:?}", w(0), w(1));
        y += 0.015;
    }
}
