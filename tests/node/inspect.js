// What another program reads in glTF files: node inspect.js FILE… prints a line of JSON for each.
import { NodeIO } from '@gltf-transform/core';
import { ALL_EXTENSIONS } from '@gltf-transform/extensions';

const io = new NodeIO().registerExtensions(ALL_EXTENSIONS);

/** A sum of all numbers of an accessor, and how many there are. */
function total(accessor) {
    const numbers = accessor ? Array.from(accessor.getArray() ?? []) : [];
    return [numbers.length, numbers.reduce((sum, number) => sum + number, 0)];
}

function described(root) {
    const faces = (primitive) => (primitive.getIndices() ?? primitive.getAttribute('POSITION')).getCount();
    const corners = (mesh) => mesh.listPrimitives().reduce((sum, primitive) => sum + faces(primitive), 0);
    const sampler = (sampler) => [total(sampler.getInput()), total(sampler.getOutput())];
    const animation = (animation) => ({
        name: animation.getName(),
        samplers: animation.listSamplers().map(sampler),
        paths: animation.listChannels().map((channel) => [channel.getTargetNode()?.getName(), channel.getTargetPath()]),
    });
    const skin = (skin) => [total(skin.getInverseBindMatrices()), skin.listJoints().map((joint) => joint.getName())];
    return {
        corners: root.listMeshes().map(corners),
        round: {
            nodes: root.listNodes().map((node) => [node.getName(), node.getMatrix(), node.getMesh()?.getName()]),
            skins: root.listSkins().map(skin),
            animations: root.listAnimations().map(animation),
            materials: root.listMaterials().map((material) => [material.getName(), material.getBaseColorFactor()]),
            textures: root.listTextures().map((texture) => [texture.getName(), texture.getImage()?.byteLength]),
            targets: root.listMeshes().map((mesh) => mesh.listPrimitives()[0]?.listTargets().length),
        },
    };
}

for (const file of process.argv.slice(2)) {
    let line;
    try {
        line = described((await io.read(file)).getRoot());
    } catch (error) {
        line = { error: String(error.message ?? error) };
    }
    console.log(JSON.stringify(line));
}
