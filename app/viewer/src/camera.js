// One camera for all panes: a turntable with z upward. Its distance is kept relative to the one at
// which the whole scene fits a pane, so that panes of any shape frame it alike. It looks at first, and
// after reset(), as `view` says: {azimuth_deg, elevation_deg} of where the viewer stands.
import {MathUtils, PerspectiveCamera, Vector3} from "three";

const margin = 1.06;

function axesOf(azimuth, elevation) {
  const ca = Math.cos(azimuth), sa = Math.sin(azimuth);
  const ce = Math.cos(elevation), se = Math.sin(elevation);
  return {right: new Vector3(-sa, ca, 0), up: new Vector3(-se * ca, -se * sa, ce),
          back: new Vector3(ce * ca, ce * sa, se)};
}

export class Turntable {
  constructor(box, view) {
    this.homeAzimuth = MathUtils.degToRad(view.azimuth_deg);
    this.homeElevation = MathUtils.degToRad(view.elevation_deg);
    this.home = box.getCenter(new Vector3());
    this.radius = Math.max(1e-30, box.getSize(new Vector3()).length() / 2);
    this.corners = [];
    for (let i = 0; i < 8; ++i) {
      this.corners.push(new Vector3(i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y,
                                    i & 4 ? box.max.z : box.min.z).sub(this.home));
    }
    this.camera = new PerspectiveCamera(30, 1, 1, 10);
    this.camera.up.set(0, 0, 1);
    this.reset();
  }

  reset() {
    this.center = this.home.clone();
    this.azimuth = this.homeAzimuth;
    this.elevation = this.homeElevation;
    this.zoomed = 1;
  }

  rotate(dx, dy) {
    this.azimuth -= dx;
    this.elevation = MathUtils.clamp(this.elevation + dy, -Math.PI / 2, Math.PI / 2);
  }

  // In parts of the pane's height.
  move(dx, dy, aspect) {
    const {right, up} = this.axes();
    const step = 2 * this.distance(aspect) * Math.tan(MathUtils.degToRad(this.camera.fov / 2));
    this.center.addScaledVector(right, -dx * step).addScaledVector(up, dy * step);
  }

  // (x, y): the place that stays where it is, in parts of the pane's height from its middle.
  zoom(factor, x = 0, y = 0, aspect = 1) {
    const zoomed = MathUtils.clamp(this.zoomed * factor, 0.005, 20);
    this.move(x, y, aspect);
    this.zoomed = zoomed;
    this.move(-x, -y, aspect);
  }

  axes() {
    return axesOf(this.azimuth, this.elevation);
  }

  // At this distance all corners of the home view are inside a pane of this shape.
  fittingDistance(aspect) {
    const tangent = Math.tan(MathUtils.degToRad(this.camera.fov / 2));
    const home = axesOf(this.homeAzimuth, this.homeElevation);
    let distance = 0;
    for (const corner of this.corners) {
      const across = Math.max(Math.abs(corner.dot(home.right)) / aspect, Math.abs(corner.dot(home.up)));
      distance = Math.max(distance, corner.dot(home.back) + margin * across / tangent);
    }
    return distance;
  }

  distance(aspect) {
    return this.zoomed * this.fittingDistance(aspect);
  }

  // The camera as a pane of this shape sees through it.
  lookThrough(aspect) {
    const {camera} = this, {right, up, back} = this.axes(), distance = this.distance(aspect);
    camera.aspect = aspect;
    // As tight as the scene allows: what is drawn a little nearer than it is relies on it.
    const reach = 1.05 * this.radius + this.center.distanceTo(this.home);
    camera.near = Math.max(distance - reach, 0.02 * distance);
    camera.far = distance + reach;
    camera.updateProjectionMatrix();
    camera.position.copy(this.center).addScaledVector(back, distance);
    camera.matrixAutoUpdate = false;
    camera.matrix.makeBasis(right, up, back).setPosition(camera.position);
    camera.matrixWorldNeedsUpdate = true;
    camera.updateMatrixWorld(true);
    return camera;
  }
}
