//! Ways of storing a mesh, as values: what each is, what it holds, and what it costs.

mod any_kernel;
mod cost;
mod kernels;
mod question;
mod views;

pub use any_kernel::AnyKernel;
pub use cost::{KernelCost, LINEAR_LIMIT};
pub use kernels::{KernelNameError, Kernels};
pub use question::{KernelQuestion, Rung};
pub use views::AnyView;
