//! Every limit of the service. Nothing that comes from outside runs without one of these bounds.

use serde::{Deserialize, Serialize};

/// Bounds on what one input may ask for. Checked before the work that they bound is begun.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Limits {
    /// Bytes of one DXF file.
    pub dxf_bytes: usize,
    /// Entities of one DXF file, those inside blocks included.
    pub dxf_entities: usize,
    /// Vertices of one DXF file, all polylines together, those that curves are drawn with included.
    pub dxf_vertices: usize,
    /// Depth to which blocks may insert blocks.
    pub dxf_nesting: usize,
    /// Bytes of one line of a DXF file.
    pub dxf_line_bytes: usize,
    /// Panels of one pattern.
    pub panels: usize,
    /// Outline vertices of one panel.
    pub panel_vertices: usize,
    /// Smallest and largest side of a panel's bounding box \[m\].
    pub panel_size_m: [f64; 2],
    /// Seams of one garment.
    pub seams: usize,
    /// Panels of a pattern that seams are suggested for.
    pub suggested_panels: usize,
    /// Bytes of one JSON request.
    pub json_bytes: usize,
    /// Memory that one JSON request may take while it is read, and all of them together \[bytes\].
    pub json_memory_bytes: usize,
    /// Items of a list and fields of an object of a JSON request that have no limit of their own.
    pub list_items: usize,
    /// Characters of a text of a JSON request, and of the name of a field.
    pub text_chars: usize,
    /// Runs of one side of a seam.
    pub seam_runs: usize,
    /// Pins of one garment.
    pub pins: usize,
    /// Fabrics that one garment holds, those of the library that it uses included.
    pub garment_fabrics: usize,
    /// Elastic edges of one panel.
    pub elastic_edges: usize,
    /// Maps on one mesh.
    pub maps: usize,
    /// Bytes of the file of a body.
    pub body_bytes: usize,
    /// Vertices of the file of a body, copies at seams of its texture included.
    pub body_vertices: usize,
    /// Triangles of the file of a body.
    pub body_triangles: usize,
    /// Characters of a name.
    pub name_chars: usize,
    /// Vertices of one garment's mesh.
    pub mesh_vertices: usize,
    /// Smallest and largest mesh edge that may be asked for \[m\].
    pub edge_length_m: [f64; 2],
    /// Pairs of triangles that are looked at for crossings of one garment.
    pub crossing_pairs: usize,
    /// Greatest speed of wind \[m/s\].
    pub wind_m_s: f64,
    /// Newton iterations of one stage.
    pub iterations: usize,
    /// Steps of one trajectory.
    pub steps: u64,
    /// Positions kept of one trajectory: vertices times frames.
    pub trajectory_positions: usize,
    /// CPU time of one fit \[s\].
    pub fit_cpu_s: f64,
    /// Smallest and largest width and height of a picture \[pixels\].
    pub picture_px: [u32; 2],
    /// Runs of one study.
    pub study_runs: usize,
    /// Items of each list of a study: methods, tolerances, steps, edge lengths.
    pub study_list: usize,
    /// CPU time of one study \[s\].
    pub study_cpu_s: f64,
    /// Fits and studies waiting in the queue.
    pub queued_jobs: usize,
    /// Number of times that the process of a fit or a study may die that has one of its own; at the
    /// last it has failed.
    pub crashes: u32,
    /// Number of times that the service may die while it runs a fit or a study in a process of its
    /// own; at the last it has failed.
    pub service_deaths: u32,
    /// Attempts to start the process of a fit or a study that has one of its own, a second apart;
    /// after the last it has failed.
    pub starts: u32,
    /// Memory of the process of a fit or a study that has one of its own \[bytes\].
    pub process_memory_bytes: u64,
    /// Longest wait of one request that asks to wait \[s\].
    pub wait_s: f64,
    /// Requests that follow a fit or a study, or wait for its end, at the same time.
    pub streams: usize,
    /// Connections open at the same time; further ones wait to be taken.
    pub connections: usize,
    /// Requests worked on at the same time, those whose body still comes not counted.
    pub requests: usize,
    /// Time in which the head of a request must come, also of the next one on a connection \[s\].
    pub head_timeout_s: f64,
    /// Time for which a client may leave a connection waiting, to send a body or to take an answer;
    /// every 4 KiB that get through give it a second back \[s\].
    pub stall_timeout_s: f64,
    /// Bytes of bodies that are held at the same time.
    pub upload_bytes_in_flight: usize,
    /// Bytes of answers that wait for their clients at the same time.
    pub answer_bytes_in_flight: usize,
}

impl Default for Limits {
    fn default() -> Self {
        Self {
            dxf_bytes: 20 << 20,
            dxf_entities: 300_000,
            dxf_vertices: 1_000_000,
            dxf_nesting: 16,
            dxf_line_bytes: 64 << 10,
            panels: 500,
            panel_vertices: 20_000,
            panel_size_m: [1e-3, 20.0],
            seams: 2_000,
            suggested_panels: 100,
            json_bytes: 32 << 20,
            json_memory_bytes: 192 << 20,
            list_items: 10_000,
            text_chars: 4_096,
            seam_runs: 64,
            pins: 2_000,
            garment_fabrics: 1_200,
            elastic_edges: 1_000,
            maps: 16,
            body_bytes: 64 << 20,
            body_vertices: 1_000_000,
            body_triangles: 500_000,
            name_chars: 256,
            mesh_vertices: 300_000,
            edge_length_m: [0.002, 0.1],
            crossing_pairs: 100_000_000,
            wind_m_s: 40.0,
            iterations: 2_000,
            steps: 20_000_000,
            trajectory_positions: 10_000_000,
            fit_cpu_s: 3_600.0,
            picture_px: [16, 4_096],
            study_runs: 200,
            study_list: 16,
            study_cpu_s: 7_200.0,
            queued_jobs: 1_000,
            crashes: 2,
            service_deaths: 10,
            starts: 10,
            process_memory_bytes: 8 << 30,
            wait_s: 60.0,
            streams: 256,
            connections: 4_096,
            requests: 512,
            head_timeout_s: 15.0,
            stall_timeout_s: 20.0,
            upload_bytes_in_flight: 160 << 20,
            answer_bytes_in_flight: 96 << 20,
        }
    }
}
