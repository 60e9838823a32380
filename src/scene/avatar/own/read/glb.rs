//! Binary glTF 2.0: the triangles of all meshes of the first scene.

use super::builder::SurfaceBuilder;
use super::unreadable::unreadable;
use crate::config::Limits;
use crate::fault::Fault;
use crate::scene::avatar::TriangleMesh;
use gltf::accessor::{DataType, Dimensions};
use gltf::mesh::Mode;
use gltf::{Accessor, Gltf, Node, Primitive, Semantic};
use nalgebra::{Matrix4, Vector3};

/// Depth of nodes beyond which a file has a circle of them.
const DEPTH: usize = 64;
/// Nodes of a scene that are looked at.
const NODES: usize = 100_000;

/// Reads the triangles of a file, each mesh where its nodes put it. The vertices of a mesh with a
/// skin stay where they are bound, whatever the nodes say, as glTF has it.
pub(super) fn read(bytes: &[u8], limits: &Limits) -> Result<TriangleMesh, Fault> {
    refuse_required(bytes)?;
    let wrong = |error: gltf::Error| unreadable("", format!("it is not binary glTF 2.0: {error}"));
    let file = Gltf::from_slice(bytes).map_err(wrong)?;
    let blob = file.blob.as_deref().unwrap_or_default();
    let scene = file.default_scene().or_else(|| file.scenes().next());
    let scene = scene.ok_or_else(|| unreadable("/scenes", "the file has no scene"))?;
    let mut builder = SurfaceBuilder::new(limits);
    let mut stack: Vec<_> = scene
        .nodes()
        .map(|node| (node, Matrix4::identity(), 0))
        .collect();
    let mut seen = 0;
    while let Some((node, above, depth)) = stack.pop() {
        seen += 1;
        if depth > DEPTH || seen > NODES {
            let place = format!("/nodes/{}", node.index());
            return Err(unreadable(
                place,
                "there are too many nodes, or a circle of them",
            ));
        }
        let local = Matrix4::from(node.transform().matrix()).cast::<f64>();
        let whole = above * local;
        read_mesh(&node, &whole, (blob, &mut builder))?;
        stack.extend(node.children().map(|child| (child, whole, depth + 1)));
    }
    Ok(builder.finish())
}

/// Refuses a file whose positions are packed in a way that is not read.
fn refuse_required(bytes: &[u8]) -> Result<(), Fault> {
    let wrong = |error: gltf::Error| unreadable("", format!("it is not binary glTF 2.0: {error}"));
    let file = Gltf::from_slice_without_validation(bytes).map_err(wrong)?;
    refuse_missing(file.document.as_json())?;
    let required = &file.document.as_json().extensions_required;
    required.first().map_or(Ok(()), |name| {
        let detail = format!("the file needs the extension {name}, which is not read");
        let fault = unreadable("/extensionsRequired", detail);
        Err(fault.fix("export the body without compression and extensions"))
    })
}

/// Refuses primitives of accessors that the file has not, which the validation of the crate takes
/// for granted.
fn refuse_missing(root: &gltf::json::Root) -> Result<(), Fault> {
    for (number, mesh) in root.meshes.iter().enumerate() {
        let accessors = mesh.primitives.iter().flat_map(|p| p.attributes.values());
        if accessors
            .into_iter()
            .any(|a| a.value() >= root.accessors.len())
        {
            let place = format!("/meshes/{number}");
            return Err(unreadable(place, "it names an accessor that is not there"));
        }
    }
    Ok(())
}

fn read_mesh(
    node: &Node<'_>,
    whole: &Matrix4<f64>,
    (blob, builder): (&[u8], &mut SurfaceBuilder<'_>),
) -> Result<(), Fault> {
    let Some(mesh) = node.mesh() else {
        return Ok(());
    };
    let place_of_bound = Matrix4::identity();
    let whole = if node.skin().is_some() {
        &place_of_bound
    } else {
        whole
    };
    for primitive in mesh.primitives() {
        let place = format!("/meshes/{}/primitives/{}", mesh.index(), primitive.index());
        match primitive.mode() {
            Mode::Triangles => read_primitive(&primitive, whole, (blob, builder), &place)?,
            Mode::Points | Mode::Lines | Mode::LineLoop | Mode::LineStrip => {}
            Mode::TriangleStrip | Mode::TriangleFan => {
                let fault = unreadable(place, "the triangles are a strip or a fan");
                return Err(fault.fix("export single triangles"));
            }
        }
    }
    Ok(())
}

fn read_primitive(
    primitive: &Primitive<'_>,
    whole: &Matrix4<f64>,
    (blob, builder): (&[u8], &mut SurfaceBuilder<'_>),
    place: &str,
) -> Result<(), Fault> {
    let wrong = |detail: &str| unreadable(place, detail);
    let positions = primitive.get(&Semantic::Positions);
    let positions = positions.ok_or_else(|| wrong("the mesh has no positions"))?;
    if (positions.data_type(), positions.dimensions()) != (DataType::F32, Dimensions::Vec3) {
        return Err(wrong("the positions are not triples of floats"));
    }
    let first = builder.vertex_count();
    for item in items::<12>(&positions, blob).ok_or_else(|| wrong("positions are missing"))? {
        let [x, y, z] = [0, 4, 8].map(|k| {
            let bytes = [item[k], item[k + 1], item[k + 2], item[k + 3]];
            f64::from(f32::from_le_bytes(bytes))
        });
        let point = whole * nalgebra::Vector4::new(x, y, z, 1.0);
        builder.vertex(Vector3::new(point.x, point.y, point.z), || place.to_owned())?;
    }
    let count = builder.vertex_count() - first;
    let mut corners = Vec::with_capacity(3);
    let mut corner = |index: usize, builder: &mut SurfaceBuilder<'_>| {
        if index >= count {
            return Err(wrong("a triangle names a vertex that is not there"));
        }
        corners.push(first + index);
        if corners.len() == 3 {
            builder.polygon(&corners, || place.to_owned())?;
            corners.clear();
        }
        Ok(())
    };
    let Some(indices) = primitive.indices() else {
        return (0..count).try_for_each(|index| corner(index, builder));
    };
    let missing = || wrong("indices are missing");
    match indices.data_type() {
        DataType::U8 => {
            let mut items = items::<1>(&indices, blob).ok_or_else(missing)?;
            items.try_for_each(|item| corner(usize::from(item[0]), builder))
        }
        DataType::U16 => {
            let mut items = items::<2>(&indices, blob).ok_or_else(missing)?;
            items.try_for_each(|item| corner(usize::from(u16::from_le_bytes(item)), builder))
        }
        DataType::U32 => {
            let mut items = items::<4>(&indices, blob).ok_or_else(missing)?;
            items.try_for_each(|item| corner(u32::from_le_bytes(item) as usize, builder))
        }
        _ => Err(wrong("the indices are not whole numbers")),
    }
}

/// Returns the items of an accessor, of `N` bytes each; none where they are not all in the file.
fn items<'a, const N: usize>(
    accessor: &Accessor<'_>,
    blob: &'a [u8],
) -> Option<impl Iterator<Item = [u8; N]> + use<'a, N>> {
    if accessor.sparse().is_some() || accessor.size() != N {
        return None;
    }
    let view = accessor.view()?;
    if !matches!(view.buffer().source(), gltf::buffer::Source::Bin) {
        return None;
    }
    let bytes = blob.get(view.offset()..)?.get(..view.length())?;
    let bytes = bytes.get(accessor.offset()..)?;
    let (count, stride) = (accessor.count(), view.stride().unwrap_or(N).max(N));
    // the last item needs no more than its own bytes
    let needed = count.checked_sub(1)?.checked_mul(stride)?.checked_add(N)?;
    let bytes = bytes.get(..needed)?;
    let chunks = bytes.chunks(stride);
    Some(chunks.filter_map(|chunk| chunk.first_chunk::<N>().copied()))
}
