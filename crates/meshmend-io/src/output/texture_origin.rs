//! Where texture coordinates count from: the lower left corner of the picture in most formats, the upper left one in
//! glTF.

use meshmend_core::{DraftError, Layer, Role, Values};

use crate::formats::facts::TextureOrigin;
use crate::{Loss, LossKind, Prepared, WriteErrorKind};

impl Prepared {
    /// Turns texture coordinates upside down if the format of the output counts them from another corner than that of
    /// the input: v becomes 1 − v, in double precision. Meshes that come from no file count from the lower left.
    ///
    /// *Cost*: O(1) where the corner is the same; else linear in the pools of texture coordinates.
    pub(crate) fn turn_textures(&mut self) -> Result<(), WriteErrorKind> {
        let origin = self.options.shell.format().map_or(TextureOrigin::LowerLeft, |f| f.texture_origin());
        let is_turned = |layer: &Layer| layer.role() == Role::TexCoord && layer.width() > 1;
        if origin == self.format.texture_origin() || !self.mesh.layers().iter().any(is_turned) {
            return Ok(());
        }
        let layers = self.mesh.layers().iter().map(|layer| {
            let turned = if is_turned(layer) { turned(layer) } else { None };
            let (layer, loss) = turned.unwrap_or_else(|| (layer.clone(), None));
            self.losses.extend(loss);
            layer
        });
        let layers = layers.collect();
        self.mesh = self.mesh.clone().with_layers(layers).map_err(DraftError::from)?;
        Ok(())
    }
}

/// A layer with its second numbers turned, and a loss if some of them would not turn back. `None`: its values are no
/// places in a picture.
fn turned(layer: &Layer) -> Option<(Layer, Option<Loss>)> {
    let mut values = fractions(layer)?;
    let (width, count) = (layer.width(), layer.value_count());
    let mut rounded = 0;
    for v in values.iter_mut().skip(1).step_by(width) {
        let turned = 1.0 - *v;
        rounded += usize::from(1.0 - turned != *v && !v.is_nan());
        *v = turned;
    }
    let loss = Loss::if_any(LossKind::Converted, rounded, |rounded| {
        let name = layer.name();
        format!("values of `{name}` rounded as they are counted from another corner: {rounded} of {count}")
    });
    Some((layer.clone().with_pool(width, Values::F64(values)).with_normalized(false), loss))
}

/// The values of a layer as fractions; `None` for integers that stand for themselves, names and lists.
fn fractions(layer: &Layer) -> Option<Vec<f64>> {
    match layer.values() {
        Values::F64(values) => Some(values.clone()),
        Values::F32(values) => Some(values.iter().map(|&x| f64::from(x)).collect()),
        Values::U8(values) if layer.is_normalized() => {
            Some(values.iter().map(|&x| f64::from(x) / 255.0).collect())
        }
        Values::U16(values) if layer.is_normalized() => {
            Some(values.iter().map(|&x| f64::from(x) / 65535.0).collect())
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use meshmend_core::{Carry, Domain};

    use super::*;

    fn layer(values: Values) -> Layer {
        Layer::direct("texcoord", Domain::Vertex, 2, Carry::Interpolate, values).with_role(Role::TexCoord)
    }

    #[test]
    fn what_is_turned_comes_back_or_is_named() {
        let exact = [0.0, 0.25, 0.1_f32, 1.0, 0.3, -2.5, 7.0, 0.7].map(f64::from);
        let (once, loss) = turned(&layer(Values::F64(exact.to_vec()))).unwrap();
        assert_eq!((once.values().number(1), loss), (Some(0.75), None));
        let (twice, loss) = turned(&once).unwrap();
        assert_eq!((twice.values(), loss), (&Values::F64(exact.to_vec()), None));
        let (_, loss) = turned(&layer(Values::F64(vec![0.0, 1e-30, 0.0, 0.5]))).unwrap();
        let loss = loss.unwrap();
        assert_eq!((loss.kind, loss.count), (LossKind::Converted, 1));
        assert_eq!(
            loss.message,
            "values of `texcoord` rounded as they are counted from another corner: 1 of 2"
        );
    }

    #[test]
    fn bytes_that_stand_for_fractions_become_fractions() {
        let bytes = layer(Values::U8(vec![0, 51]));
        assert!(turned(&bytes).is_none());
        let (turned, _) = turned(&bytes.with_normalized(true)).unwrap();
        assert_eq!(turned.values(), &Values::F64(vec![0.0, 0.8]));
        assert!(!turned.is_normalized());
    }
}
