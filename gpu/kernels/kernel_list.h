// SPDX-License-Identifier: GPL-3.0-or-later
// The list of all kernels, so that one file compiles them for the device: in float for use, and in
// double so that tests can tell a wrong step from rounding.
#pragma once

#include "gpu/kernels/assembly_kernels.h"
#include "gpu/kernels/coarse_kernels.h"
#include "gpu/kernels/kernel.h"
#include "gpu/kernels/solve_kernels.h"
#include "gpu/kernels/step_kernels.h"

namespace hepatica::gpu {
namespace detail {

template <class... List>
struct Joined;
template <class List>
struct Joined<List> {
    using Type = List;
};
template <class... A, class... B, class... Rest>
struct Joined<KernelList<A...>, KernelList<B...>, Rest...> {
    using Type = typename Joined<KernelList<A..., B...>, Rest...>::Type;
};

template <class Real>
using KernelsOf =
    KernelList<ForEach<EvaluateTurned<Real>>, ForEach<EvaluateCorotated<Real>>,
               ForEach<EvaluateCorotated10<Real>>, ForEach<EvaluateNeoHookean<Real>>,
               ForEach<EvaluateSprings<Real>>, ForEach<GatherStiffness<Real>>,
               ForEach<InvertDiagonal<Real>>,
               SumRows<Real, View<const Quad<Real>>, KeepProduct<Real>, ChooseStep>,
               SumRows<Real, View<const Vector3<double>>, KeepProduct<double>, KeepSums<1>>,
               SumRows<Real, View<const Vector3<double>>, KeepResidual, KeepSums<1>>,
               SumWhole<BeginRound<Real>, StartIteration>, ForEach<Unsummed<BeginRound<Real>>>,
               SumWhole<TakeStep<Real>, EndIteration>, ForEach<Unsummed<TakeStep<Real>>>,
               ForEach<TurnDirection<Real>>, ForEach<AddCorrection<Real>>,
               ForEach<ShapeModes<Real>>, ProjectElements<Real>, EliminateCuts<Real>,
               InvertFactor<Real>, SumBelow<Real>, DivideByPivots<Real>, SumAbove<Real>,
               SumSegments<RestrictResidual<Real>, KeepSums<3 * coarse_vectors>>,
               SumChunks<RestrictResidual<Real>>, SumWhole<AddMotion<Real>, StartIteration>,
               SumWhole<AddMotion<Real>, EndIteration>, SumWhole<AddMotion<Real>, KeepSums<2>>>;

using SharedKernels =
    KernelList<ForEach<GatherForces>, ForEach<PullGrabs>, ForEach<PressPoints>, ForEach<PressPairs>,
               ForEach<RubPoints>, ForEach<PullTies>, ForEach<ForeseeSlips>, ForEach<SetRows>,
               ForEach<KeepForces>, ForEach<PlaceNodes>, ForEach<Descent>, ForEach<Subtract>,
               SumWhole<BeginSolve, KeepSums<1>>, SumWhole<AlongDirection, KeepSums<2>>,
               SumWhole<Works, KeepSums<3>>, SumSegments<Energies, KeepSums<Energies::width>>,
               SumChunks<Energies>, SumSegments<CentreOfNode, KeepCentre>, SumChunks<CentreOfNode>,
               GatherProjected, FinishSum<KeepCentre>, FinishSum<KeepSums<3 * coarse_vectors>>,
               FinishSum<KeepSums<Energies::width>>>;

}  // namespace detail

using AllKernels = detail::Joined<detail::KernelsOf<float>, detail::KernelsOf<double>,
                                  detail::SharedKernels>::Type;

}  // namespace hepatica::gpu
